# Files that the program holds: assembler takes them in as they are, and a table says where they lie. Sets
# SPECTRALPACK_EMBEDDED to the sources made. The page is made from web/ (docs/developing.md) and kept in web/dist.
set(page ${PROJECT_SOURCE_DIR}/web/dist)
set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded)
file(MAKE_DIRECTORY ${out})
file(GLOB_RECURSE page_files RELATIVE ${page} CONFIGURE_DEPENDS ${page}/*)
file(GLOB sample_files RELATIVE ${PROJECT_SOURCE_DIR}/data/samples CONFIGURE_DEPENDS
     ${PROJECT_SOURCE_DIR}/data/samples/*.stl ${PROJECT_SOURCE_DIR}/data/samples/*.obj
     ${PROJECT_SOURCE_DIR}/data/samples/samples.csv)
set(assembler "")
set(embedded_files "")
set(declared "")
set(page_table "")
set(sample_table "")
set(number 0)

# embed(NAME file): the file's bytes from NAME to NAME_end.
macro(embed name file)
    string(APPEND assembler ".global ${name}\n.global ${name}_end\n${name}:\n.incbin \"${file}\"\n${name}_end:\n.byte 0\n")
    string(APPEND declared "extern const char ${name}[], ${name}_end[];\n")
    list(APPEND embedded_files ${file})
endmacro()

foreach(file ${page_files})
    math(EXPR number "${number} + 1")
    file(SHA256 ${page}/${file} hash)
    string(SUBSTRING ${hash} 0 20 hash)
    execute_process(COMMAND gzip -9 -n -c ${page}/${file} OUTPUT_FILE ${out}/${number}.gz COMMAND_ERROR_IS_FATAL ANY)
    set(type application/octet-stream)
    foreach(known "html=text/html; charset=utf-8" "js=text/javascript" "css=text/css" "svg=image/svg+xml" "png=image/png"
                  "webp=image/webp" "ico=image/x-icon" "json=application/json" "txt=text/plain; charset=utf-8")
        string(REGEX MATCH "^([a-z]+)=(.*)$" matched "${known}")
        if(file MATCHES "\\.${CMAKE_MATCH_1}$")
            string(REGEX REPLACE "^[a-z]+=" "" type "${known}")
        endif()
    endforeach()
    embed(sp_page_${number} ${page}/${file})
    embed(sp_packed_${number} ${out}/${number}.gz)
    string(APPEND page_table "    {\"${file}\", \"${type}\", \"\\\"${hash}\\\"\", SPAN(sp_page_${number}), SPAN(sp_packed_${number})},\n")
endforeach()
foreach(file ${sample_files})
    math(EXPR number "${number} + 1")
    embed(sp_sample_${number} ${PROJECT_SOURCE_DIR}/data/samples/${file})
    string(APPEND sample_table "    {\"${file}\", SPAN(sp_sample_${number})},\n")
endforeach()
embed(sp_api ${CMAKE_CURRENT_SOURCE_DIR}/openapi.json)

file(CONFIGURE OUTPUT ${out}/files.S CONTENT ".section .rodata\n${assembler}.section .note.GNU-stack,\"\",%progbits\n" @ONLY)
file(CONFIGURE OUTPUT ${out}/tables.inc CONTENT
"extern \"C\" {\n${declared}}\n#define SPAN(name) std::string_view(name, static_cast<std::size_t>(name##_end - name))\nconst PageFile kPageFiles[] = {\n${page_table}    {},\n};\nconst SampleFile kSampleFiles[] = {\n${sample_table}    {},\n};\n#undef SPAN\n" @ONLY)
set(SPECTRALPACK_EMBEDDED ${out}/files.S)
set_property(SOURCE ${out}/files.S APPEND PROPERTY OBJECT_DEPENDS "${embedded_files}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${embedded_files}")
include_directories(${CMAKE_CURRENT_BINARY_DIR})
