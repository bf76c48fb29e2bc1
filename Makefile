# Makefile -- short commands for users. Each target installs the Debian packages that it lacks, then calls CMake.
.DEFAULT_GOAL := help
.PHONY: help run install uninstall one-file view clip gallery web reference test test-full test-platforms fuzz bench build packages lists format check \
	release clean

cores := $(shell nproc 2>/dev/null || echo 2)

build_packages := gcc libc6-dev cmake ninja-build pkg-config libjansson-dev libcairo2-dev opencl-c-headers \
	ocl-icd-libopencl1 pocl-opencl-icd
view_packages := g++ libglfw3-dev libimgui-dev libepoxy-dev libvulkan-dev libegl1 libgl1-mesa-dri
web_packages := cmake ninja-build emscripten binaryen node-acorn nodejs terser
test_packages := $(view_packages) xvfb twm xdotool git clang-format libcmocka-dev libsdl2-dev gnuplot-nox ffmpeg jq \
	libopenmpi-dev openmpi-bin
ifneq ($(shell uname -m),aarch64)
test_packages += gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user # for test_aarch64; 56 MB
endif
full_packages := $(web_packages) doxygen clang libclang-rt-dev chromium chromium-driver node-typescript

help: ## print this list
	@echo 'make TARGET, where TARGET is one of'
	@sed -n 's/^\([a-z-]*\):[^#]*## \(.*\)/  \1\t\2/p' Makefile | expand -t 17

build: ## build the library and the command line: build/libscree.a, build/libscree.so, build/scree
	@tools/packages.sh $(build_packages)
	@cmake --preset release --log-level=NOTICE $(build_options)
	@cmake --build --preset release --target scree_products

run: build ## simulate a pile of mixed shapes and draw its end
	@build/scree run pile --picture build/pile.png
	@echo 'The picture is build/pile.png'

install: build ## install library, command line and manual page (PREFIX=/usr/local)
	@cmake --install build --prefix $(or $(PREFIX),/usr/local)

uninstall: ## remove what make install has installed
	@cmake --build build --target uninstall

one-file: ## write the CPU library as one file, build/one_file/scree_all.c, with its header
	@tools/one_file.sh build/one_file
	@echo 'The library is build/one_file/scree_all.c, its header build/one_file/scree/scree.h'

view: build_packages += $(view_packages)
view: build ## open a window on a scene (SCENE=pile)
	@build/scree view $(or $(SCENE),pile)

clip: build ## make a video of 600 steps of a scene, ten seconds of pile (SCENE=pile)
	@tools/packages.sh ffmpeg
	@build/scree run $(or $(SCENE),pile) --steps 600 --video build/clip.mp4
	@echo 'The video is build/clip.mp4'

gallery: build_packages += ffmpeg jq
gallery: build ## draw all scenes as pictures and short clips on one page, build/gallery/index.html (SCENES=...)
	@tools/gallery.sh build/gallery $(SCENES)

web: build_packages += $(web_packages)
web: build ## build the page build/web and the npm package build/web/package, by WebAssembly
	@tools/source.sh jansson build/sources/jansson
	@for form in scalar simd threads; do \
		cmake --preset wasm-$$form --log-level=NOTICE && cmake --build --preset wasm-$$form || exit 1; \
	done
	@node web/make_page.mjs build/scree build build/web
	@node web/package/pack.mjs . build/wasm-scalar build/wasm-simd build/web/package
	@echo 'The npm package is build/web/package'
	@echo 'The page is build/web, for any web server. To open it: node web/serve.mjs build/web'

reference: ## build the reference of the public interface: build/reference/index.html
	@tools/packages.sh doxygen
	@tools/reference.sh . build/reference
	@echo 'The reference is build/reference/index.html'

packages:
	@tools/packages.sh $(build_packages) $(test_packages)

test: packages ## run the tests, on the CPU and through OpenCL: minutes
	@tools/source.sh jansson build/sources/jansson || echo 'scree: test_aarch64 will be skipped'
	@cmake --preset test --log-level=NOTICE
	@cmake --build --preset test
	@ctest --preset test --parallel $(cores)

test-full: test_packages += $(full_packages)
test-full: packages ## run all tests, also with clang, sanitizers, one lane, WebAssembly and a browser: much longer
	@tools/source.sh jansson build/sources/jansson
	@cmake --preset test-full --log-level=NOTICE
	@cmake --build --preset test-full
	@ctest --preset test-full --parallel $(cores)

test-platforms: ## build for other processors and for Windows, and compare hashes in emulators (ROW=...)
	@tests/platforms.sh $(ROW)

fuzz: ## search for inputs that crash the library or the reader of scenes, with libFuzzer (SECONDS=60)
	@tools/packages.sh $(build_packages) clang libclang-rt-dev
	@tests/fuzz/fuzz.sh --seconds $(or $(SECONDS),60)

bench: build ## measure on the CPU, and on the GPU if there is one, for some minutes, into bench/results/NAME (NAME=local)
	@tools/packages.sh gnuplot-nox
	@bench/bench.sh $(NAME)

lists: ## write the tables of docs/manual/scenes.md and docs/manual/view.md, and the schema of scene files
	@tools/packages.sh $(build_packages)
	@cmake --preset release --log-level=NOTICE
	@cmake --build --preset release --target scene_lists
	@tools/lists.sh build/tests

format: ## format every C file
	@tools/packages.sh git clang-format
	@git ls-files --cached --others --exclude-standard '*.c' '*.h' | xargs clang-format -i

check: packages build ## run the tests that take seconds: documents, format, units; no scenes, no other presets
	@cmake --build --preset release
	@ctest --preset release --label-exclude parity --parallel $(cores)

release: ## make tarballs of sources, page and npm package of this version in build/release, with SHA256SUMS
	@tools/release.sh

clean: ## remove build/
	@rm -rf build
