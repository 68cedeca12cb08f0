# What `cmake --install` puts where: components program, reference, development (docs/building.md).

# The library that other projects link is all rooms in one, without the reference engine (GPL); shared with
# -DBUILD_SHARED_LIBS=ON.
include(cmake/spectralpackDependencies.cmake)
set(library_needs Threads::Threads TBB::tbb Qhull::qhull_r fmt::fmt EXPAT::EXPAT PkgConfig::LIBZIP embree PNG::PNG fcl
    hwy::hwy)
set(tools_need fmt::fmt meshoptimizer::meshoptimizer)
get_property(rooms GLOBAL PROPERTY SPECTRALPACK_ROOMS)
list(REMOVE_ITEM rooms spectralpack_search_reference)
if(TARGET spectralpack_tools)
    list(REMOVE_ITEM rooms spectralpack_tools)
else()
    list(APPEND library_needs meshoptimizer::meshoptimizer)
endif()
set(objects "")
foreach(room ${rooms} spectralpack_without_reference)
    list(APPEND objects $<TARGET_OBJECTS:${room}>)
endforeach()

# spectralpack_installed(TARGET name objects...): a library as others see it, spectralpack::NAME.
function(spectralpack_installed target name)
    add_library(${target} ${ARGN})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION}
                          SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    install(TARGETS ${target} EXPORT spectralpackTargets COMPONENT development)
endfunction()

spectralpack_installed(spectralpack_library spectralpack ${objects})
set_target_properties(spectralpack_library PROPERTIES OUTPUT_NAME spectralpack)
target_link_libraries(spectralpack_library PRIVATE ${library_needs})
install(DIRECTORY include/spectralpack DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
        FILES_MATCHING PATTERN *.hpp PATTERN tools EXCLUDE)
# Generating, preparing, inspecting and measuring: beside the product, spectralpack::tools.
if(TARGET spectralpack_tools)
    spectralpack_installed(spectralpack_tools_library tools $<TARGET_OBJECTS:spectralpack_tools>)
    set_target_properties(spectralpack_tools_library PROPERTIES OUTPUT_NAME spectralpack_tools)
    target_link_libraries(spectralpack_tools_library PUBLIC spectralpack_library PRIVATE ${tools_need})
    install(DIRECTORY include/spectralpack/tools DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/spectralpack
            COMPONENT development FILES_MATCHING PATTERN *.hpp)
endif()

# The CMake package.
include(CMakePackageConfigHelpers)
set(library_is_shared OFF)
if(BUILD_SHARED_LIBS)
    set(library_is_shared ON)
endif()
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/spectralpack)
install(EXPORT spectralpackTargets NAMESPACE spectralpack:: DESTINATION ${package_dir} COMPONENT development)
configure_package_config_file(cmake/spectralpackConfig.cmake.in ${PROJECT_BINARY_DIR}/share/spectralpackConfig.cmake
                              INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/share/spectralpackConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/share/spectralpackConfig.cmake
              ${PROJECT_BINARY_DIR}/share/spectralpackConfigVersion.cmake
              cmake/spectralpackDependencies.cmake
        DESTINATION ${package_dir} COMPONENT development)

# The pkg-config file. A static library brings its needs along, which then are everybody's.
set(pkgconfig_needs "-lfmt -lexpat -lzip -lembree3 -lpng16 -lfcl -lccd -lhwy -ltbb -lqhull_r -pthread")
if(BUILD_SHARED_LIBS)
    set(pkgconfig_private "${pkgconfig_needs}")
    set(pkgconfig_needs "")
endif()
file(RELATIVE_PATH pkgconfig_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/spectralpack.pc.in ${PROJECT_BINARY_DIR}/share/spectralpack.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/share/spectralpack.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)

# Man page and completions, written by the program's own option table.
if(TARGET spectralpack_docs)
    set(share ${PROJECT_BINARY_DIR}/share)
    install(FILES ${share}/spectralpack.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
    install(FILES ${share}/spectralpack.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
            RENAME spectralpack COMPONENT program)
    install(FILES ${share}/_spectralpack DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT program)
    install(FILES ${share}/spectralpack.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
            COMPONENT program)
endif()
