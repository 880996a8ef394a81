# batten_library(NAME FOLDERS ... USES ... LINK ...): a shared library made of folders of src/.
# Its objects are compiled once; the tests link the objects so that they reach the bat_ functions,
# everything else links the library, which shows only batten_ names.
function(batten_library name)
    cmake_parse_arguments(ARG "" "" "FOLDERS;USES;LINK" ${ARGN})
    set(sources)
    foreach(folder ${ARG_FOLDERS})
        file(GLOB_RECURSE found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*.c)
        list(APPEND sources ${found})
    endforeach()

    add_library(${name}-objects OBJECT ${sources})
    set_target_properties(${name}-objects PROPERTIES
        POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden)
    # What ships stays below a page of stack. Under the sanitizers the bound says nothing: they pad
    # each array and keep a copy of it for every place that a function is inlined to.
    if(NOT "${CMAKE_C_FLAGS} ${CMAKE_C_FLAGS_DEBUG}" MATCHES "-fsanitize")
        target_compile_options(${name}-objects PRIVATE
            $<$<C_COMPILER_ID:GNU>:-Wstack-usage=4096>)
    endif()
    target_include_directories(${name}-objects
        PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(${name}-objects PRIVATE batten_warnings PUBLIC ${ARG_LINK})

    add_library(${name} SHARED $<TARGET_OBJECTS:${name}-objects>)
    add_library(batten::${name} ALIAS ${name})
    set_target_properties(${name} PROPERTIES
        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR} LINKER_LANGUAGE C
        INSTALL_RPATH $ORIGIN)
    target_include_directories(${name} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
    target_link_libraries(${name} PUBLIC ${ARG_USES} PRIVATE ${ARG_LINK})
endfunction()
