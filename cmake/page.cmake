# page.cmake -- builds the WebAssembly of the page, with scenes and with the renderer of view/ for WebGL 2. docs/manual/web_page.md
# describes the page.
include(cmake/glsl.cmake)

# excludes files that open OpenGL, share memory with it or read pictures back: the page does not use them
file(GLOB page_view CONFIGURE_DEPENDS view/*.c)
list(FILTER page_view EXCLUDE REGEX "/(shared_rows|exported_memory|offscreen|framebuffer|gl_picture)\\.c$")

if(CMAKE_C_FLAGS MATCHES "-pthread")
	set(form threads)
elseif(CMAKE_C_FLAGS MATCHES "-msimd128")
	set(form simd)
else()
	set(form scalar)
endif()

add_executable(scree_page web/page.c web/page_tools.c web/page_change.c web/page_inspect.c web/page_moment.c web/page_picture.c web/page_rows.c web/page_wall.c ${page_view})
scree_flags(scree_page)
scree_glsl(scree_page)
set_target_properties(scree_page PROPERTIES OUTPUT_NAME scree-${form} SUFFIX .js)
target_link_libraries(scree_page PRIVATE scree_scene_internals scree_common scree_internals m)
target_compile_options(scree_page PRIVATE -O2) # drawing takes as long as a step
target_link_options(scree_page PRIVATE -O2 -sMODULARIZE -sEXPORT_ES6 -sEXPORT_NAME=scree -sENVIRONMENT=web,worker
	-sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=2GB -sINITIAL_MEMORY=64MB -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
	-sFORCE_FILESYSTEM -sINCOMING_MODULE_JS_API=locateFile,print,printErr,workers
	-sEXPORTED_RUNTIME_METHODS=GL,FS,UTF8ToString,allocateUTF8 -sEXPORTED_FUNCTIONS=_malloc,_free -sABORTING_MALLOC=0)
if(form STREQUAL threads)
	# creates all workers before the first world, because a thread that waits for another thread cannot start that
	# thread
	target_link_options(scree_page PRIVATE -pthread -sPTHREAD_POOL_SIZE=Module.workers -Wno-pthreads-mem-growth
		-sEXPORTED_RUNTIME_METHODS=GL,FS,UTF8ToString,allocateUTF8,PThread)
endif()
