#!/usr/bin/env bash
# test_package.sh -- installs the library into a scratch folder, and builds the examples with it, static and shared: all
# through CMake, and hello.c and scene.c also through pkg-config. The four builds of each must print the same.
set -euo pipefail
scratch=$SCREE_BUILD/package
rm -rf "$scratch"
mkdir -p "$scratch"
trap 'rm -rf "$scratch"' EXIT
export CC=${CC:-cc}

cmake --install "$SCREE_BUILD" --prefix "$scratch/first" >"$scratch/log"
# moves the installed tree, which must work in any folder
mv "$scratch/first" "$scratch/prefix"
prefix=$scratch/prefix
libdir=$(dirname "$(find "$prefix" -name pkgconfig -type d)")

for shared in OFF ON; do
	build=$scratch/cmake_$shared
	cmake -S "$SCREE_SOURCE/examples" -B "$build" -DCMAKE_PREFIX_PATH="$prefix" -DBUILD_SHARED_LIBS=$shared >>"$scratch/log" ||
		{ cat "$scratch/log"; exit 1; }
	cmake --build "$build" >>"$scratch/log" || { cat "$scratch/log"; exit 1; }
	LD_LIBRARY_PATH=$libdir "$build/hello" | tee "$scratch/cmake_$shared.txt"
	LD_LIBRARY_PATH=$libdir "$build/car" | tee "$scratch/car_$shared.txt"
	LD_LIBRARY_PATH=$libdir "$build/time" | tee "$scratch/time_$shared.txt"
	LD_LIBRARY_PATH=$libdir "$build/train" | tee "$scratch/train_$shared.txt"
	cmp "$scratch/train_OFF.txt" "$scratch/train_$shared.txt"
	if [ -x "$build/step8_gpu" ]; then # SDL2 is installed
		SDL_VIDEODRIVER=dummy LD_LIBRARY_PATH=$libdir "$build/step8_gpu" --frames 60 | tee "$scratch/game_$shared.txt"
		cmp "$scratch/game_OFF.txt" "$scratch/game_$shared.txt"
	fi
	LD_LIBRARY_PATH=$libdir "$build/rollback" --demo --threads 1 --speed 8 --frames 240 --delay 60 --log 240
	if [ -f "$libdir/libscree_scene.a" ]; then
		LD_LIBRARY_PATH=$libdir "$build/scene" "$SCREE_SOURCE/scenes/wrecking-ball.json" "$scratch/scene_$shared.json" | tee "$scratch/scene_$shared.txt"
		grep -q 'bodies after 60 steps' "$scratch/scene_$shared.txt"
		(cd "$scratch" && LD_LIBRARY_PATH=$libdir "$build/evolve" "$SCREE_SOURCE/scenes/walker.json" cpu 1) | tee "$scratch/evolve_$shared.txt"
		grep -q 'as in the batch' "$scratch/evolve_$shared.txt"
		cmp "$scratch/evolve_OFF.txt" "$scratch/evolve_$shared.txt"
	fi
	linked=$(objdump -p "$build/hello" | grep -c 'NEEDED.*libscree' || true)
	[ "$linked" = "$([ $shared = ON ] && echo 1 || echo 0)" ] || { echo "BUILD_SHARED_LIBS=$shared links the wrong library"; exit 1; }
done

export PKG_CONFIG_PATH=$libdir/pkgconfig
[ "$(pkg-config --modversion scree)" = "$(sed -n 's/^#define SCREE_VERSION_[A-Z]* //p' "$SCREE_SOURCE/include/scree/scree.h" | paste -sd .)" ]
hello=$SCREE_SOURCE/examples/hello.c
# the output of pkg-config must be split into words
$CC -std=c17 -Wall -Wextra -Werror "$hello" -o "$scratch/hello_shared" $(pkg-config --cflags --libs scree)
$CC -std=c17 -Wall -Wextra -Werror "$hello" -o "$scratch/hello_static" $(pkg-config --cflags scree) "$libdir/libscree.a" \
	$(pkg-config --static --libs scree | sed 's/-lscree//')
LD_LIBRARY_PATH=$libdir "$scratch/hello_shared" | tee "$scratch/pc_shared.txt"
"$scratch/hello_static" | tee "$scratch/pc_static.txt"

for other in cmake_ON pc_shared pc_static; do
	cmp "$scratch/cmake_OFF.txt" "$scratch/$other.txt"
done
if [ -f "$libdir/libscree_scene.a" ]; then
	cmp "$scratch/scene_OFF.json" "$scratch/scene_ON.json"
	scene=$SCREE_SOURCE/examples/scene.c
	$CC -std=c17 -Wall -Wextra -Werror "$scene" -o "$scratch/scene_shared" $(pkg-config --cflags --libs scree_scene)
	$CC -std=c17 -Wall -Wextra -Werror "$scene" -o "$scratch/scene_static" $(pkg-config --cflags scree_scene) "$libdir/libscree_scene.a" \
		"$libdir/libscree.a" $(pkg-config --static --libs scree_scene | sed 's/-lscree\(_scene\)*//g')
	for form in shared static; do
		LD_LIBRARY_PATH=$libdir "$scratch/scene_$form" "$SCREE_SOURCE/scenes/wrecking-ball.json" "$scratch/scene_pc.json"
		sed -i 's/scene_pc/scene_OFF/g' "$scratch/scene_pc.json"
		cmp "$scratch/scene_OFF.json" "$scratch/scene_pc.json"
	done
	strangers=$(nm -D --defined-only "$libdir/libscree_scene.so" | awk '{print $3}' | grep -v '^scree_scene_' || true)
	[ -z "$strangers" ] || { echo "libscree_scene.so exports: $strangers"; exit 1; }
fi
if [ -f "$libdir/libscree_mpi.a" ]; then
	mpi=$SCREE_SOURCE/tests/tools/mpi_worlds.c
	OMPI_CC=$CC MPICH_CC=$CC mpicc -std=c17 -Wall -Wextra -Werror "$mpi" -o "$scratch/mpi_shared" $(pkg-config --cflags --libs scree_mpi) -lm
	[ -x "$scratch/cmake_ON/evolve_mpi" ] || { echo "evolve_mpi was not built"; exit 1; }
	mkdir "$scratch/mpi"
	printf 'cmake_minimum_required(VERSION 3.22)\nproject(worlds C)\nfind_package(scree REQUIRED COMPONENTS mpi)\nadd_executable(worlds %s)\ntarget_link_libraries(worlds scree::mpi m)\n' \
		"$mpi" >"$scratch/mpi/CMakeLists.txt"
	cmake -S "$scratch/mpi" -B "$scratch/mpi/build" -DCMAKE_PREFIX_PATH="$prefix" >>"$scratch/log"
	cmake --build "$scratch/mpi/build" >>"$scratch/log" || { cat "$scratch/log"; exit 1; }
	for program in "$scratch/mpi_shared" "$scratch/mpi/build/worlds"; do
		# a program of MPI that is started alone has one rank
		LD_LIBRARY_PATH=$libdir OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "$program" | tee "$scratch/mpi.txt"
		grep -q '^after failures: sum ' "$scratch/mpi.txt"
	done
	strangers=$(nm -D --defined-only "$libdir/libscree_mpi.so" | awk '{print $3}' | grep -v '^scree_mpi_' || true)
	[ -z "$strangers" ] || { echo "libscree_mpi.so exports: $strangers"; exit 1; }
fi
grep -q 'the box rests at .*, 0\.[45]' "$scratch/cmake_OFF.txt"
# the car drives over the bump and stays on its wheels
cmp "$scratch/car_OFF.txt" "$scratch/car_ON.txt"
cmp "$scratch/time_OFF.txt" "$scratch/time_ON.txt"
grep -q '^steps of 1/60 s: 80 steps, 1.15 s dropped, .*, 4\.49' "$scratch/time_OFF.txt"
grep -q '^3\.0 s: the car is at 1[0-9]\..*, 0\.[89]' "$scratch/car_OFF.txt"

# the library exports only names of its interface
strangers=$(nm -D --defined-only "$libdir/libscree.so" | awk '{print $3}' | grep -v '^scree_' || true)
[ -z "$strangers" ] || { echo "libscree.so exports: $strangers"; exit 1; }
strangers=$(nm -g --defined-only "$libdir/libscree.a" | awk 'NF == 3 { print $3 }' | grep -v '^scree_' || true)
[ -z "$strangers" ] || { echo "libscree.a has the global names" $strangers; exit 1; }

# all headers also compile as C++
if command -v c++ >/dev/null; then
	echo '#include <scree/scree_scene.h>' | c++ -x c++ -fsyntax-only -Wall -Wextra -Werror -I "$SCREE_SOURCE/include" -
	echo '#include <scree/scree_math.h>' | c++ -x c++ -fsyntax-only -Wall -Wextra -Werror $(pkg-config --cflags scree) -
fi

# the installed command line finds the installed scenes
if [ -x "$prefix/bin/scree" ]; then
	"$prefix/bin/scree" scenes --names | grep -qx pile
fi

# licence, examples, manual page and completion are installed, and the address in scree.pc
for file in share/doc/scree/LICENSE share/doc/scree/README.md share/doc/scree/examples/first_game/window.h share/bash-completion/completions/scree share/man/man1/scree.1; do
	[ -s "$prefix/$file" ] || { echo "$file is not installed"; exit 1; }
done
pkg-config --print-variables scree >/dev/null
grep -q '^URL: .' "$libdir/pkgconfig/scree.pc"
grep -q '^\.SS scree replay' "$prefix/share/man/man1/scree.1"
completed=$(PATH=$prefix/bin:$PATH bash -c '. "$1"; COMP_WORDS=(scree run pyr); COMP_CWORD=2; _scree; echo "${COMPREPLY[*]}"' sh \
	"$prefix/share/bash-completion/completions/scree")
[[ " $completed " == *" pyramid "* ]] || { echo "scree run pyr is completed to: $completed"; exit 1; }

# the target uninstall removes every file
cmake --install "$SCREE_BUILD" --prefix "$scratch/second" >>"$scratch/log"
cmake --build "$SCREE_BUILD" --target uninstall >>"$scratch/log"
left=$(find "$scratch/second" ! -type d)
[ -z "$left" ] || { echo "uninstall leaves:" $left; exit 1; }

# packages have the files of an installation
if command -v cpack >/dev/null; then
	(cd "$SCREE_BUILD" && cpack -G TGZ -B "$scratch/packages" >>"$scratch/log")
	tar -tzf "$scratch"/packages/scree-*.tar.gz >"$scratch/list"
	for file in "lib.*libscree.a" include/scree/scree.h share/doc/scree/LICENSE; do
		grep -q "/$file\$" "$scratch/list" || { echo "the package lacks $file"; exit 1; }
	done
fi
