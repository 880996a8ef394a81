# batten_library(NAME FOLDERS ... USES ... LINK ...): a library made of folders of src/; shared, or static with
# BUILD_SHARED_LIBS=OFF. Its objects are compiled once; the tests link the objects so that they reach the bat_
# functions, everything else links the library, which shows only batten_ names.
option(BUILD_SHARED_LIBS "Shared libraries; OFF: static ones" ON)

# Until 1.0 each minor version may break what programs were linked with.
set(BATTEN_SOVERSION ${PROJECT_VERSION_MAJOR})
if(PROJECT_VERSION_MAJOR EQUAL 0)
    set(BATTEN_SOVERSION 0.${PROJECT_VERSION_MINOR})
endif()

# Where a library or program finds the libraries installed beside it: batten_origin(OUT SUBFOLDER).
function(batten_origin out subfolder)
    if(APPLE)
        set(${out} "@loader_path${subfolder}" PARENT_SCOPE)
    else()
        set(${out} "$ORIGIN${subfolder}" PARENT_SCOPE)
    endif()
endfunction()

# What leaves a shared library, and under which version, whatever the compiler's visibility.
function(batten_exports name)
    if(APPLE)
        set(list ${PROJECT_SOURCE_DIR}/cmake/exports.txt)
        target_link_options(${name} PRIVATE -Wl,-exported_symbols_list,${list})
    elseif(UNIX)
        set(list ${PROJECT_SOURCE_DIR}/cmake/exports.map)
        # Calls inside go straight to their functions and not through a table that others might overwrite.
        target_link_options(${name} PRIVATE -Wl,--version-script=${list} -Wl,-Bsymbolic-functions)
    else()
        return()
    endif()
    set_target_properties(${name} PROPERTIES LINK_DEPENDS ${list})
endfunction()

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

    add_library(${name} $<TARGET_OBJECTS:${name}-objects>)
    add_library(batten::${name} ALIAS ${name})
    batten_origin(beside "")
    set_target_properties(${name} PROPERTIES
        VERSION ${PROJECT_VERSION} SOVERSION ${BATTEN_SOVERSION} LINKER_LANGUAGE C
        INSTALL_RPATH "${beside}")
    if(BUILD_SHARED_LIBS)
        batten_exports(${name})
    endif()
    target_include_directories(${name} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${name} PUBLIC ${ARG_USES} PRIVATE ${ARG_LINK})
endfunction()
