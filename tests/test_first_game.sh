#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_first_game.sh -- runs the eight steps of docs/first_game.md without a display: hashes are those of the page, with 1 and 2
# threads, through OpenCL and in a replay. make test-full also follows the page's four ways to build a game, command by command.
set -uo pipefail
page=${SCREE_SOURCE:?}/docs/first_game.md
game=${SCREE_BUILD:?}/first_game
. "$SCREE_SOURCE/tests/cli_support.sh"

if [ ! -x "$game/step1_box" ]; then
	echo "skipped: the first game was not built, because SDL2 was not found; Debian has it in libsdl2-dev"
	[[ " ${SCREE_EXPECT:-} " = *" sdl "* ]] && exit 1
	exit 77
fi
begin "$game/step1_box"
export SDL_VIDEODRIVER=dummy

# the options of the page's table of hashes
eval "options=($(sed -n 's/^build\/game \(--frames .*\) --picture .*/\1/p' "$page"))"
[ "${#options[@]}" = 4 ] || fail "$page has no line with --frames, --keys and --picture"

# hash_of STEP: the hash of a step in the table of the page
hash_of()
{
	sed -n "s/^| \`$1\` .*| \`\([0-9a-f]\{16\}\)\` |$/\1/p" "$page"
}

# play STEP TEXT words...: runs a step, which must end well, print TEXT and have the hash of the page
play()
{
	local step=$1 text=$2
	shift 2
	program=$game/$step
	expect 0 "$text" "${options[@]}" "$@"
	[ "$(tail -n 1 out)" = "hash $(hash_of "$step")" ] || fail "$step $*: $(tail -n 1 out), and \"$(hash_of "$step")\" in the page"
}

steps=0
for source in "$SCREE_SOURCE"/examples/first_game/step*.c; do
	step=$(basename "$source" .c)
	play "$step" "hash" --threads 1
	play "$step" "hash" --threads 2 --picture "$step.bmp"
	head -c 2 "$step.bmp" | grep -q BM || fail "$step: no picture"
	steps=$((steps + 1))
done
[ "$steps" = 8 ] || fail "there are $steps steps, not 8"

# the parts do what the page says
play step2_hero 'the hero is at'
play step3_coins 'coins; the hero'
play step5_bridge '5 coins; the hero is at 3' # the car has crossed the bridge
play step6_rays 'seen 1 times'

# a replay has the hash of its recording; the keys of a changed recording, or another hash in it, are found
program=$game/step7_replay
play step7_replay 'seen 1 times' --record keys.txt
[ "$(head -n 1 keys.txt | tr -d '\n' | wc -c)" = "${options[1]}" ] || fail "the recording has not one character per step"
expect 0 'the replay has the same hash' --replay keys.txt --frames 100000 --threads 2
expect 0 "hash $(hash_of step7_replay)" --replay keys.txt --frames 100000
sed '1s/^B/@/' keys.txt >changed.txt # without the key right in the first step
expect 1 'the replay has another hash' --replay changed.txt --frames 100000
sed '2s/.*/0123456789abcdef/' keys.txt >changed.txt
expect 1 'the replay has another hash' --replay changed.txt --frames 100000
: >empty.txt
expect 1 'the replay has another hash' --replay empty.txt --frames 100000
refuse 2 'missing.txt: cannot be opened' --replay missing.txt
refuse 2 'cannot be combined' --replay keys.txt --record keys.txt
if [ -w /dev/full ]; then
	expect 1 'cannot be written' --record /dev/full --frames 10
fi

# options
refuse 2 '--dance: unknown option' --frames 1 --dance
refuse 2 '--frames: must be a whole number' --frames many
refuse 2 '--frames: a value must follow' --frames
refuse 2 '--keys: must be like' --frames 1 --keys 5x
refuse 1 'def.threads is 65' --frames 1 --threads 65
program=$game/step8_gpu
refuse 1 'def.device is "gpu"' --frames 1 --device gpu
program=$game/step1_box
refuse 2 '--device: unknown option' --frames 1 --device cpu

# the avalanche on the CPU and through OpenCL; device auto, made to try OpenCL, moves the world and changes no bit
program=$game/step8_gpu
short=(--frames 150 --keys "112r 2rj 66r" --stones 120)
expect 0 'the world is on cpu' "${short[@]}" --device cpu
hash=$(tail -n 1 out)
"$program" --frames 1 --device opencl >out 2>err
if grep -q 'There is no OpenCL\|has no OpenCL' err; then
	cat err
	[[ " ${SCREE_EXPECT:-} " != *" opencl "* ]] || fail "no OpenCL, on which tests are to run"
else
	expect 0 'the world is on opencl:' "${short[@]}" --device opencl
	[ "$(tail -n 1 out)" = "$hash" ] || fail "OpenCL: $(tail -n 1 out), and $hash on the CPU"
	SCREE_AUTO=opencl expect 0 "$hash" "${short[@]}"
	grep -q 'OpenCL\|opencl' err || fail "device auto does not report its decision"
fi

# The four ways to build a game, as the page has them. Words that would change the system or use a network are replaced here.
if [ "${SCREE_QUICK:-1}" = 0 ] && command -v git >/dev/null; then
	# block LANGUAGE N: the Nth block of a language in the page
	block()
	{
		awk -v fence="\`\`\`$1" -v number="$2" '
			$0 == fence { inside = 1; ++count; next }
			/^```/ { inside = 0 }
			inside && count == number' "$page"
	}
	# follow N [FOLDER]: runs the Nth block of commands, in a folder, without the game itself
	follow()
	{
		cd "$scratch/${2:-hour}" && eval "$(block sh "$1" | grep -v '^build/game')" >>"$scratch/log" 2>&1 || { tail "$scratch/log"; fail "commands $1 of $page"; }
		cd "$scratch" || exit 1
	}
	# way NAME COMMANDS: builds the game in the folder game by these commands, and compares its hash
	way()
	{
		rm -rf hour/game/build
		follow "$2" hour/game
		program=$scratch/hour/game/build/game
		expect 0 "hash $(hash_of step1_box)" "${options[@]}"
		echo "$1: same hash"
	}
	sudo() { [ "$1" = apt-get ] || "$@"; }
	ldconfig() { :; }
	git() # clones the present sources, committed or not
	{
		mkdir scree && (cd "$SCREE_SOURCE" && tar -c --exclude=./build --exclude=./.git .) | tar -x -C scree &&
			command git -C scree init -q -b main && command git -C scree add -A &&
			command git -C scree -c user.name=test -c user.email=test commit -qm test
	}
	make() # uses the build that is tested
	{
		case $* in
		build) ;;
		install*) cmake --install "$SCREE_BUILD" --prefix "$scratch/prefix" ;;
		*) command make "$@" ;;
		esac
	}
	export GIT_CONFIG_COUNT=1 GIT_CONFIG_KEY_0=url.file://$scratch/hour/scree.insteadOf GIT_CONFIG_VALUE_0=https://example.org/scree
	mkdir hour
	follow 1
	block cmake 1 >hour/game/CMakeLists.txt
	way FetchContent 2
	follow 3 hour/scree
	export CMAKE_PREFIX_PATH=$scratch/prefix
	libdir=$(dirname "$(find "$scratch/prefix" -name pkgconfig -type d)")
	export PKG_CONFIG_PATH=$libdir/pkgconfig LD_LIBRARY_PATH=$libdir
	block cmake 2 >hour/game/CMakeLists.txt
	way find_package 2
	way pkg-config 4
	follow 5 hour/game
	block make 1 >hour/game/Makefile
	way makefile 6
fi
end
