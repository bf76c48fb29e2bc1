# program.cmake -- scree_embed(target entry name): adds an OpenCL program to a target, as the array of chars `name`.
file(GLOB_RECURSE SCREE_KERNEL_FILES CONFIGURE_DEPENDS src/*.h src/*.cl src/*.def tools/paper/*.h
	tools/paper/*.cl)

function(scree_embed target entry name)
	set(out ${PROJECT_BINARY_DIR}/${name}.c)
	add_custom_command(OUTPUT ${out}
		COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DENTRY=${entry} -DNAME=${name} -DOUT=${out}
			-P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
		DEPENDS ${SCREE_KERNEL_FILES} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
		COMMENT "Embedding ${entry}" VERBATIM)
	target_sources(${target} PRIVATE ${out})
endfunction()
