# `cpack` in the build folder makes Debian packages: spectralpack, libspectralpack-dev and, where the reference engine
# is built, spectralpack-reference, which alone is GPL (docs/dependencies.md).
set(doc ${CMAKE_INSTALL_DATADIR}/doc)
install(FILES LICENSE DESTINATION ${doc}/spectralpack RENAME copyright COMPONENT program)
install(FILES LICENSE DESTINATION ${doc}/libspectralpack-dev RENAME copyright COMPONENT development)
set(CPACK_COMPONENTS_ALL program development)
if(SPECTRALPACK_REFERENCE)
    list(APPEND CPACK_COMPONENTS_ALL reference)
    install(FILES cmake/reference_copyright DESTINATION ${doc}/spectralpack-reference RENAME copyright
            COMPONENT reference)
endif()

if(SPECTRALPACK_PYTHON)
    list(APPEND CPACK_COMPONENTS_ALL python)
    install(FILES LICENSE DESTINATION ${doc}/python3-spectralpack RENAME copyright COMPONENT python)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "spectralpack developers <spectralpack@localhost>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME spectralpack)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "${PROJECT_DESCRIPTION}
 The command spectralpack.")

set(CPACK_DEBIAN_REFERENCE_PACKAGE_NAME spectralpack-reference)
set(CPACK_DEBIAN_REFERENCE_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_REFERENCE_DESCRIPTION "${PROJECT_DESCRIPTION}, with the reference engine
 The command spectralpack-reference: the same as spectralpack, with the plain
 method besides (FFTW), to compare with. Licensed under the GPL.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-spectralpack)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.9), python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${PROJECT_DESCRIPTION} (Python)
 The package spectralpack for Python 3, with numpy arrays in and out.")

# A static library names what it needs; a shared one has its own dependencies.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libspectralpack-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libtbb-dev, libqhull-dev, libfmt-dev, libexpat1-dev, libzip-dev, \
libembree-dev, libpng-dev, libfcl-dev, libhwy-dev, libmeshoptimizer-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${PROJECT_DESCRIPTION} (library)
 Headers, library and CMake package, for C++20.")
include(CPack)
