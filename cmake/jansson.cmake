# jansson.cmake -- builds Jansson from its sources, because no system has a package of it for WebAssembly.
set(SCREE_JANSSON_SOURCE ${PROJECT_SOURCE_DIR}/build/sources/jansson CACHE PATH
	"Folder of Jansson's sources; tools/source.sh jansson FOLDER fetches them")
file(GLOB jansson_sources ${SCREE_JANSSON_SOURCE}/src/*.c)
if(jansson_sources)
	# Jansson's folder android/ has the configuration for a system without locales; the definitions below replace Jansson's private
	# configuration
	set(made ${PROJECT_BINARY_DIR}/jansson)
	file(CONFIGURE OUTPUT ${made}/jansson_private_config.h CONTENT "")
	add_library(scree_jansson STATIC ${jansson_sources})
	target_include_directories(scree_jansson SYSTEM PUBLIC ${SCREE_JANSSON_SOURCE}/src ${SCREE_JANSSON_SOURCE}/android
		PRIVATE ${made})
	target_compile_definitions(scree_jansson PRIVATE HAVE_STDINT_H)
	set(jansson scree_jansson)
	set(JANSSON_FOUND ON)
endif()
