# paper.cmake -- builds the pipeline of the paper that Scree started from, as a library that tests use too, and its command line,
# scree_paper.
file(GLOB paper_sources CONFIGURE_DEPENDS tools/paper/*.c)
set(pipeline_sources ${paper_sources})
list(FILTER pipeline_sources INCLUDE REGEX "/(all_pairs|import|paper|paper_cpu|paper_opencl|paper_state|resolve)\\.c$")
list(REMOVE_ITEM paper_sources ${pipeline_sources})
if(NOT opencl)
	list(FILTER pipeline_sources EXCLUDE REGEX "/paper_opencl\\.c$")
endif()

add_library(scree_paper_pipeline STATIC ${pipeline_sources})
scree_flags(scree_paper_pipeline)
target_link_libraries(scree_paper_pipeline PUBLIC scree_internals PRIVATE scree_common)
if(opencl)
	scree_embed(scree_paper_pipeline tools/paper/paper_kernels.cl paper_program)
	target_include_directories(scree_paper_pipeline SYSTEM PRIVATE ${SCREE_CL_INCLUDE_DIR})
else()
	target_compile_definitions(scree_paper_pipeline PRIVATE SCREE_NO_OPENCL)
endif()

# not installed, because scree_paper only repeats measurements
# it draws through a pipe to gnuplot, by the shell of a POSIX system
if(TARGET scree_cli_common AND UNIX)
	add_executable(scree_paper ${paper_sources})
	scree_flags(scree_paper)
	set_target_properties(scree_paper PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
	target_link_libraries(scree_paper PRIVATE scree_cli_common scree_paper_pipeline)
endif()
