# names.cmake -- scree_names(out prefix objects...): links libraries of objects into one object, in which only names that begin
# with the prefix are global.
#
# The static libraries hold this object instead of the libraries' objects, because otherwise a program that has a function
# named `launch` would not link. The object is machine code even if the program is compiled with -flto: in the
# compiler's intermediate code, names could not be made local.
set(SCREE_LOCAL_NAMES OFF)
if(CMAKE_OBJCOPY AND CMAKE_LINKER AND NOT APPLE AND NOT MSVC AND NOT EMSCRIPTEN)
	set(SCREE_LOCAL_NAMES ON)
elseif(NOT EMSCRIPTEN)
	message(NOTICE "scree: the static libraries have global names other than scree_*, because there is no objcopy for this platform")
endif()

function(scree_names out prefix)
	set(parts "")
	foreach(objects IN LISTS ARGN)
		set_target_properties(${objects} PROPERTIES INTERPROCEDURAL_OPTIMIZATION OFF)
		target_compile_options(${objects} PRIVATE -fno-lto)
		list(APPEND parts $<TARGET_OBJECTS:${objects}>)
	endforeach()
	set(folder ${CMAKE_CURRENT_BINARY_DIR}/names/$<CONFIG>)
	set(linked ${folder}/${prefix}linked.o)
	set(object ${folder}/${prefix}local.o)
	add_custom_command(OUTPUT ${object}
		COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
		COMMAND ${CMAKE_LINKER} -r -o ${linked} ${parts}
		COMMAND ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=${prefix}* ${linked} ${object}
		DEPENDS ${ARGN} ${parts} COMMAND_EXPAND_LISTS VERBATIM
		COMMENT "Making all names but ${prefix}* local")
	set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
	set(${out} ${object} PARENT_SCOPE)
endfunction()
