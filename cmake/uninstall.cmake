# uninstall.cmake -- removes the files that `cmake --install` listed, and the folders that are then empty; the files
# of DESTDIR, if it is set.
#
# cmake -DMANIFEST=build/installed.txt -P cmake/uninstall.cmake
if(NOT EXISTS "${MANIFEST}")
	message(FATAL_ERROR "scree: nothing to remove, because ${MANIFEST} does not exist; cmake --install writes it")
endif()
file(STRINGS "${MANIFEST}" files)
foreach(file IN LISTS files)
	set(file "$ENV{DESTDIR}${file}")
	if(EXISTS "${file}" OR IS_SYMLINK "${file}")
		message(STATUS "Removing ${file}")
		file(REMOVE "${file}")
	endif()
	# only folders with the name of the library are removed, since other folders belong to the system
	get_filename_component(folder "${file}" DIRECTORY)
	while(folder MATCHES "/scree(/.*)?$")
		file(GLOB left "${folder}/*")
		if(left)
			break()
		endif()
		file(REMOVE_RECURSE "${folder}")
		get_filename_component(folder "${folder}" DIRECTORY)
	endwhile()
endforeach()
