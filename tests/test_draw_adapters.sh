#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_draw_adapters.sh -- draws a small world through the adapters of examples/draw/, with stand-ins for raylib, SDL and Dear
# ImGui that print each call; compiles them also with the libraries that are installed.
set -euo pipefail
cd "$SCREE_SOURCE"
scratch=$(mktemp -d "${SCREE_BUILD:?}/test_draw_adapters.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
failed=0
complain()
{
	echo "FAILED: $*"
	failed=1
}

# compile NAME COMPILER... : compiles the program for an adapter; the caller adds the folder of the library
compile()
{
	local name=$1
	shift
	"$@" -Wall -Wextra -Werror -Wno-unused-function -Iinclude -Iexamples/draw "-DADAPTER=\"draw_$name.h\"" "-DVIEW=$view"
}

# draw NAME VIEW COMPILER...: draws through an adapter and its stand-in, and checks the calls
draw()
{
	local name=$1 view=$2 text
	shift 2
	compile "$name" "$@" -Itests/draw tests/draw/draw_adapter.c -x none "$SCREE_BUILD/libscree.a" -lm -ldl -pthread \
		-o "$scratch/$name" || { complain "$name does not compile"; return; }
	"$scratch/$name" >"$scratch/$name.txt" || { complain "$name does not run"; return; }
	# the box: 40 by 20 pixels around the middle of the window; ImGui has clockwise fills, whose area is negative
	grep -qE '^fill 4 -?800 7fae7c80$' "$scratch/$name.txt" || complain "$name: no box"
	grep -q '^line 80,40 80,60 7fae7cff$' "$scratch/$name.txt" || complain "$name: no left side of the box"
	# the disc: pi 10^2 less 0.6 % for its 32 edges; its spoke points to the right
	grep -qE '^fill 33 -?312 e8b06080$' "$scratch/$name.txt" || complain "$name: no disc"
	grep -q '^line 150,30 160,30 e8b060ff$' "$scratch/$name.txt" || complain "$name: no spoke"
	# the capsule: 20 by 10 pixels, and two half discs, pi 5^2 less 2.6 %
	grep -qE '^fill 18 -?277 e8b06080$' "$scratch/$name.txt" || complain "$name: no capsule"
	# the disc that is not in the window is not drawn
	[ "$(grep -c '^fill 33' "$scratch/$name.txt")" = 1 ] || complain "$name: the second disc is drawn"
	text=$(grep -c '^text .* [123] ffffffff$' "$scratch/$name.txt" || true)
	[ "$text" = "$([ "$name" = sdl ] && echo 0 || echo 3)" ] || complain "$name: $text texts"
}

draw raylib 'raylib_view(200.0f, 100.0f, 10.0f)' "${CC:-cc}" -std=c17 -DPREPARE=
draw sdl 'sdl_view(&list, 200.0f, 100.0f, 10.0f)' "${CC:-cc}" -std=c17 '-DPREPARE=SDL_Renderer list'
if command -v c++ >/dev/null; then
	draw imgui 'imgui_view(&list, 200.0f, 100.0f, 10.0f)'  c++ '-DPREPARE=ImDrawList list' -x c++
fi

# with the libraries themselves, where they are installed
for library in raylib sdl2 imgui; do
	pkg-config --exists "$library" 2>/dev/null || continue
	case $library in
	imgui) language=c++ view='imgui_view(nullptr, 1, 1, 1)' ;;
	sdl2) language=c view='sdl_view(NULL, 1, 1, 1)' ;;
	*) language=c view='raylib_view(1, 1, 1)' ;;
	esac
	# the flags of pkg-config must be split into words
	compile "${library%2}" $([ $language = c ] && echo "${CC:-cc}" || echo c++) -x $language -DPREPARE= -fsyntax-only \
		$(pkg-config --cflags "$library") tests/draw/draw_adapter.c || complain "$library: does not compile"
	echo "$library: compiled with the library"
done
exit $failed
