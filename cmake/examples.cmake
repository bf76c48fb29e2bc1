# examples.cmake -- builds examples that tests run: rollback, train, evolve, and the steps of the first game, whose window needs SDL2.
file(GLOB rollback_sources CONFIGURE_DEPENDS examples/rollback/*.c)

# not installed: it is a source to read; examples/CMakeLists.txt builds all examples with an installed library
if(UNIX)
	# the sockets are those of POSIX
	add_executable(rollback ${rollback_sources})
	scree_flags(rollback)
	target_link_libraries(rollback PRIVATE scree::scree m)
endif()

# a cart learns to balance a pole, in a batch
add_executable(train examples/train.c)
scree_flags(train)
target_link_libraries(train PRIVATE scree::scree $<$<NOT:$<BOOL:${WIN32}>>:m>)

# evolution of a gait in a batch; evolve_mpi over the ranks of MPI
if(TARGET scree::scene)
	add_executable(evolve examples/evolve.c)
	target_link_libraries(evolve PRIVATE scree::scene)
	scree_flags(evolve)
	if(TARGET scree::mpi)
		add_executable(evolve_mpi examples/evolve.c)
		target_compile_definitions(evolve_mpi PRIVATE EVOLVE_MPI)
		target_link_libraries(evolve_mpi PRIVATE scree::scene scree::mpi)
		scree_flags(evolve_mpi)
	endif()
endif()

if(NOT CMAKE_CROSSCOMPILING)
	find_package(PkgConfig)
	if(PkgConfig_FOUND)
		pkg_check_modules(SDL2 IMPORTED_TARGET sdl2>=2.0.18)
	endif()
	if(SDL2_FOUND)
		file(GLOB steps CONFIGURE_DEPENDS examples/first_game/step*.c)
		foreach(source IN LISTS steps)
			get_filename_component(step ${source} NAME_WE)
			add_executable(first_game_${step} ${source})
			scree_flags(first_game_${step})
			target_include_directories(first_game_${step} PRIVATE examples/draw)
			target_link_libraries(first_game_${step} PRIVATE scree::scree PkgConfig::SDL2 m)
			set_target_properties(first_game_${step} PROPERTIES OUTPUT_NAME ${step}
				RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/first_game)
		endforeach()
	else()
		message(NOTICE "scree: the first game is left out, because SDL2 was not found; Debian has it in libsdl2-dev")
	endif()
endif()
