# names.cmake -- scree_names(objects out): links a library of objects into one object, in which only names that begin with scree_
# are global.
#
# The static library holds this object instead of the library's objects, because otherwise a program that has a function
# named `launch` would not link. The object is machine code even if the program is compiled with -flto: in the
# compiler's intermediate code, names could not be made local.
function(scree_names objects out)
	set_target_properties(${objects} PROPERTIES INTERPROCEDURAL_OPTIMIZATION OFF)
	target_compile_options(${objects} PRIVATE -fno-lto)
	set(linked ${CMAKE_CURRENT_BINARY_DIR}/names/$<CONFIG>/linked.o)
	set(object ${CMAKE_CURRENT_BINARY_DIR}/names/$<CONFIG>/scree.o)
	add_custom_command(OUTPUT ${object}
		COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_CURRENT_BINARY_DIR}/names/$<CONFIG>
		COMMAND ${CMAKE_LINKER} -r -o ${linked} $<TARGET_OBJECTS:${objects}>
		COMMAND ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=scree_* ${linked} ${object}
		DEPENDS ${objects} $<TARGET_OBJECTS:${objects}> COMMAND_EXPAND_LISTS VERBATIM
		COMMENT "Making all names but scree_* local")
	set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
	set(${out} ${object} PARENT_SCOPE)
endfunction()
