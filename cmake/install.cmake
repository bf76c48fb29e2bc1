# install.cmake -- selects the files of `cmake --install` and their folders: header, libraries, package files, scenes,
# command line.
include(CMakePackageConfigHelpers)

set(forms "")
foreach(name static shared scene_static scene_shared)
	if(TARGET scree_${name})
		list(APPEND forms scree_${name})
	endif()
endforeach()
install(TARGETS ${forms} EXPORT scree-targets
	ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
	LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
	RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES include/scree/scree.h include/scree/scree_math.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scree)
if(TARGET scree::scene)
	install(FILES include/scree/scree_scene.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scree)
endif()
# targets of their own, because only programs that use them need MPI
if(TARGET scree::mpi)
	set(forms "")
	foreach(name mpi_static mpi_shared)
		if(TARGET scree_${name})
			list(APPEND forms scree_${name})
		endif()
	endforeach()
	install(TARGETS ${forms} EXPORT scree-mpi-targets
		ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
		LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
	install(FILES include/scree/scree_mpi.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scree)
	install(EXPORT scree-mpi-targets NAMESPACE scree:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scree)
endif()
if(TARGET scree_cli)
	install(TARGETS scree_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
	install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/scree FILES_MATCHING PATTERN "*.json")
	install(FILES cli/scree.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME scree)
	if(UNIX AND NOT CMAKE_CROSSCOMPILING)
		# the help of the command line is also its manual page
		add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/scree.1
			COMMAND sh ${PROJECT_SOURCE_DIR}/tools/man.sh $<TARGET_FILE:scree_cli> ${PROJECT_BINARY_DIR}/scree.1
			DEPENDS scree_cli ${PROJECT_SOURCE_DIR}/tools/man.sh VERBATIM)
		add_custom_target(scree_man ALL DEPENDS ${PROJECT_BINARY_DIR}/scree.1)
		add_dependencies(scree_products scree_man)
		install(FILES ${PROJECT_BINARY_DIR}/scree.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
	endif()
endif()
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md") # without the pictures, 4.8 MB

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/scree)
install(EXPORT scree-targets NAMESPACE scree:: DESTINATION ${package})
configure_package_config_file(cmake/scree-config.cmake.in ${PROJECT_BINARY_DIR}/scree-config.cmake
	INSTALL_DESTINATION ${package})
# before 1.0 every minor version may change the interface
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scree-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/scree-config.cmake ${PROJECT_BINARY_DIR}/scree-config-version.cmake
	DESTINATION ${package})

# folders relative to the package file, so that an installed tree can be moved
set(pc_folder ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pc_prefix ${pc_folder} ${CMAKE_INSTALL_PREFIX})
file(RELATIVE_PATH pc_include ${pc_folder} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
set(SCREE_URL "" CACHE STRING "Address of the project in scree.pc; default: the installed documents")
set(pc_url ${SCREE_URL})
if(NOT pc_url)
	set(pc_url file://${CMAKE_INSTALL_FULL_DOCDIR}/README.md)
endif()
configure_file(cmake/scree.pc.in ${PROJECT_BINARY_DIR}/scree.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/scree.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(TARGET scree::scene)
	configure_file(cmake/scree_scene.pc.in ${PROJECT_BINARY_DIR}/scree_scene.pc @ONLY)
	install(FILES ${PROJECT_BINARY_DIR}/scree_scene.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
if(TARGET scree::mpi)
	configure_file(cmake/scree_mpi.pc.in ${PROJECT_BINARY_DIR}/scree_mpi.pc @ONLY)
	install(FILES ${PROJECT_BINARY_DIR}/scree_mpi.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

if(top)
	# The list of CMake, install_manifest.txt, is also written by cpack, whose files are not those of the user.
	install(CODE "
		if(NOT \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\" MATCHES _CPack_Packages)
			list(JOIN CMAKE_INSTALL_MANIFEST_FILES \"\\n\" files)
			file(WRITE \"${PROJECT_BINARY_DIR}/installed.txt\" \"\${files}\\n\")
		endif()")
	add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/installed.txt
		-P ${PROJECT_SOURCE_DIR}/cmake/uninstall.cmake VERBATIM)
endif()

# cpack, in the build folder, makes scree-VERSION-SYSTEM.tar.gz and, where dpkg is installed, a package for Debian
if(top)
	set(CPACK_GENERATOR TGZ)
	find_program(SCREE_DPKG dpkg-shlibdeps)
	if(SCREE_DPKG)
		list(APPEND CPACK_GENERATOR DEB)
	endif()
	set(CPACK_PACKAGE_VENDOR "The Scree authors")
	set(CPACK_PACKAGE_CONTACT "The Scree authors")
	set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
	set(CPACK_STRIP_FILES ON)
	set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
	set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
	set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
	set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ocl-icd-libopencl1, pocl-opencl-icd")
	include(CPack)
endif()
