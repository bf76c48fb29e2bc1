#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_view.sh -- checks the viewer in a virtual display: scripts, keys and mouse, pictures, other devices, and refusals.
set -uo pipefail
scree=${SCREE_BINARY:?is the path of the command line}
build=${SCREE_BUILD:?is the build folder}
# skip WHY...: skips the test; the test fails if SCREE_EXPECT requires the viewer
skip()
{
	echo "skipped: $*"
	[[ " ${SCREE_EXPECT:-} " = *" view "* ]] && exit 1
	exit 77
}
[ -x "$scree" ] || skip "no command line was built"
if ! grep -q 'keys of scree view' <<<"$("$scree" view --help)"; then
	skip "this build has no viewer: libglfw3-dev, libimgui-dev or libepoxy-dev is missing"
fi
for tool in Xvfb twm xdotool; do
	command -v "$tool" >/dev/null || skip "there is no $tool"
done
scratch=$(mktemp -d "$build/test_view.XXXXXX")
cd "$scratch" || exit 1
failures=0
unset WAYLAND_DISPLAY
# leaks are not checked: GLFW unloads the driver before the process ends, so a suppression could not name the leaking functions
export ASAN_OPTIONS=detect_leaks=0

# a virtual display of Mesa's software renderer, with a window manager that can minimize
Xvfb -displayfd 3 -screen 0 1280x900x24 3>display 2>xvfb.log &
server=$!
trap 'kill $server 2>/dev/null; wait; rm -rf "$scratch"' EXIT
for _ in $(seq 100); do
	[ -s display ] && break
	sleep 0.1
done
[ -s display ] || skip "Xvfb does not start: $(tail -n 1 xvfb.log)"
export XDG_SESSION_TYPE=x11 # without it GLFW 3.4 tries Wayland first, and its library complains
export DISPLAY=":$(cat display)" LIBGL_ALWAYS_SOFTWARE=1
printf 'RandomPlacement\nNoTitle\n' >twmrc
LC_ALL=C twm -f twmrc >twm.log 2>&1 & # in other locales it needs fonts that the server may lack
manager=$!

fail()
{
	echo "FAILED: $*"
	sed 's/^/    | /' out err
	failures=$((failures + 1))
}

# view CODE words...: runs scree view with the words and with the script on standard input; checks the exit code
view()
{
	local code=$1 got
	shift
	cat >script
	timeout 120 "$scree" view "$@" --device cpu --size 800x600 --script script >out 2>err
	got=$?
	[ "$got" = "$code" ] || fail "scree view $*: exit code $got instead of $code"
}

# says TEXT: checks that the last call of view printed the text
says()
{
	grep -qF -- "$1" out err || fail "it does not say \"$1\""
}

# nth COLUMN LINE: prints one column of a line that the command "print" wrote
nth()
{
	sed -n "$2p" out | tr ',' '\n' | sed -n "s/^ *$1 //p"
}

# within ONE OTHER MEAN SHARE: succeeds if the difference of two pictures has at most this mean and this share
# (picture_difference.c)
within()
{
	"$build/tests/difference" "$1" "$2" >out 2>err && awk -v mean="$3" -v share="$4" '{exit !($1 <= mean && $2 <= share)}' out
}

small=(pyramid --set rows=3)

# the picture of the window equals the picture of scree run with the same view; without --view, scree run would add the
# magnified detail of the scene
whole=(--view -1.68,-3,1.68,6) # the view of the small scene: 0.56 * 3 is 1.68
view 0 "${small[@]}" <<'END'
frames 30
print
picture window.png
key 2
key 3
key 4
key 5
key 1
frames 2
picture layers.png
END
says 'steps 30'
[ "$(nth hash 1)" = "$("$scree" hash "${small[@]}" --steps 30 --device cpu)" ] || fail "another hash than scree hash"
if [ -x "$build/tests/difference" ]; then
	"$scree" run "${small[@]}" "${whole[@]}" --device cpu --steps 30 --size 800x600 --renderer gl --picture gl.png >out 2>err ||
		fail "run --renderer gl"
	within window.png gl.png 0.5 0.002 || fail "window and picture are not alike"
	"$scree" run "${small[@]}" "${whole[@]}" --device cpu --steps 30 --size 800x600 --renderer cairo --picture cairo.png >out 2>err ||
		fail "run --renderer cairo"
	within window.png cairo.png 1.0 0.01 || fail "OpenGL and Cairo are not alike"
	for renderer in gl cairo; do
		"$scree" run "${small[@]}" --device cpu --steps 30 --size 800x600 --renderer $renderer --picture detail_$renderer.png >out 2>err ||
			fail "run --renderer $renderer of a scene with a detail"
	done
	within detail_gl.png detail_cairo.png 1.0 0.01 || fail "details of OpenGL and Cairo are not alike"
	within detail_gl.png window.png 1.0 0.01 && fail "a picture shows no detail"
	"$scree" run "${small[@]}" "${whole[@]}" --device cpu --steps 32 --size 800x600 --picture layers_gl.png \
		--layers contacts,normals,impulses,velocities,boxes >out 2>err || fail "run --layers"
	within layers.png layers_gl.png 0.5 0.002 || fail "layers in window and picture are not alike"
	within layers.png window.png 0.1 0 && fail "layers do not show"
fi

# a wall of worlds: the first one moves as the scene does alone, in each of the others random inputs move the bodies. r returns
# to the start; what would change the worlds, or reads the template, is refused
doll=(ragdolls --set columns=1 --set rows=1)
wall()
{
	view 0 "$@" <<'END'
frames 40
print
picture wall.png
key r
frames 40
print
picture again.png
key t
print
key 7
print
button down
cursor 300 300
frames 2
button up
print
key c
key c
print
END
}
for scene in "${doll[*]}" walker; do
	read -ra words <<<"$scene"
	wall "${words[@]}" --worlds 9
	alone=$("$scree" hash "${words[@]}" --steps 40 --device cpu)
	[ "$(nth hash 1)" = "$alone" ] || fail "wall: another hash than scree hash"
	[ "$(nth hash 2)" = "$alone" ] || fail "wall: another hash after a restart"
	says 'says a wall of worlds cannot do this'
	says 'painted by type'
	[ "$(nth middle 5)" != "$(nth middle 2)" ] || fail "wall: a drag does not move the picture"
	cmp -s wall.png again.png || fail "wall: other inputs after a restart"
done
if [ -x "$build/tests/difference" ]; then
	# all bodies stay in the view, because a tile ends there
	printf '{"name":"two","title":"Two balls fall","view":[-4,-4,4,4],"attributes":{"a":{"circle":0.5}},
"bodies":[{"attribute":"a"},{"attribute":"a","position":[0.7,1.5]}]}' >two.json
	view 0 ./two.json --worlds 1 <<'END'
frames 40
key z
frames 1
picture one.png
key z
frames 1
picture next.png
END
	"$scree" run ./two.json --device cpu --steps 41 --size 800x600 --renderer gl --layers centers --picture alone.png >out 2>err ||
		fail "run --layers centers"
	within one.png alone.png 0.01 0.0001 || fail "wall of one world: another picture than that of scree run"
	within next.png alone.png 0.1 0.001 && fail "wall: a layer does not show"
fi
for line in 'rewind 0' 'device cpu' 'scene pile' 'load x.snap'; do
	view 2 "${doll[@]}" --worlds 4 <<<"$line"
	says 'cannot be done'
done
view 2 churn --worlds 4 <<<print
says 'churn has churn, which the worlds of a batch cannot have'
view 2 walker --worlds 2000 <<<print
says '--worlds 2000: must be at most 1024'
view 2 walker --worlds 4 --paint speed <<<print
says '--paint speed cannot show a wall of worlds'
view 2 walker --worlds 4 --load x.snap <<<print
says '--load has no effect: --worlds shows a wall of worlds'

# the body under the cursor: a click selects it, a drag does not. Escape ends the selection; a second Escape ends the viewer. None
# of this changes the hash
view 0 "${small[@]}" <<'END'
key tab
frames 1
cursor 400 342
frames 2
print
button down
frames 1
button up
cursor 400 100
frames 2
print
cursor 400 342
button down
frames 1
cursor 480 300
frames 1
button up
cursor 10 550
frames 2
print
key o
cursor 400 342
frames 1
print
key esc
frames 1
print
key esc
frames 5
print
END
sed -n 1p out | grep -q ', hovered crate of body [0-9]*$' || fail "hover: nothing under the cursor"
sed -n 2p out | grep -q 'panel at 1.00, selected crate of body [0-9]*$' || fail "click: nothing selected, or something under an empty place"
[ "$(sed -n 's/.*hovered \(.*\)/\1/p' out | head -n 1)" = "$(nth selected 2)" ] || fail "click: another body than that under the cursor"
[ "$(nth selected 3)" = "$(nth selected 2)" ] || fail "a drag selects"
sed -n 4p out | grep -q hovered && fail "o does not switch hovering off"
sed -n 5p out | grep -q selected && fail "esc does not forget"
[ "$(wc -l <out)" = 5 ] || fail "the second esc does not end"
view 0 "${small[@]}" <<'END'
key tab
frames 1
cursor 400 342
frames 9
button down
button up
key u
key i
key 0
key b
frames 20
print
END
[ "$(nth hash 1)" = "$("$scree" hash "${small[@]}" --steps 30 --device cpu)" ] || fail "hovering, selecting or looking for events changes the hash"

# the viewer reports that a selected body was destroyed: churn soon replaces each body
view 0 churn --set columns=4 --set rows=4 --set moved=0 --set replaced=4 <<'END'
key tab
frames 1
cursor 445 235
button down
button up
print
frames 6
print
END
says ' (destroyed)'

# sensors and rays, drawn by OpenGL and by Cairo; events flash, and all kinds of events may be enabled
cat >eyes.json <<'END'
{"name": "eyes", "title": "Sensors and rays", "view": [-6, -1, 6, 6], "attributes": {
	"floor": {"box": [10, 0.5]}, "ball": {"circle": 0.5}, "zone": {"box": [1, 0.8], "radius": 0.2}},
"bodies": [
	{"type": "static", "attribute": "floor", "position": [0, -0.5]},
	{"name": "ball", "attribute": "ball", "position": [-2, 3]},
	{"type": "kinematic", "attribute": "zone", "sensor": 1, "position": [0, 3]}],
"collidables": [{"attribute": "zone", "sensor": 1, "position": [-2, 1]}],
"rays": [{"position": [3, 5], "count": 40, "length": 8}, {"from": "ball", "count": 9, "length": 2}],
"keys": [{"key": "right", "body": "ball", "force": [20, 0]}]}
END
view 0 ./eyes.json <<'END'
frames 20
picture before.png
frames 22
picture window.png
key 8
key 9
frames 1
picture bare.png
END
if [ -x "$build/tests/difference" ]; then
	for renderer in gl cairo; do
		"$scree" run ./eyes.json --device cpu --steps 42 --size 800x600 --renderer $renderer --picture $renderer.png >out 2>err ||
			fail "run --renderer $renderer of sensors"
	done
	within window.png gl.png 0.5 0.002 || fail "sensors and rays in window and picture are not alike"
	within window.png cairo.png 1.0 0.01 || fail "sensors and rays of OpenGL and Cairo are not alike"
	within window.png before.png 1.0 0.002 && fail "a sensor with something inside looks like an empty one"
	within window.png bare.png 1.0 0.002 && fail "sensors and rays are not hidden"
fi
view 0 ./eyes.json <<'END'
key u
key i
key 0
key 8
frames 1
key e
key 8
frames 60
print
picture many.png
hold right
frames 40
release right
frames 1
print
END
[ "$(nth rays 1)" = '49 of 49' ] || fail "not all rays are in view"
[ "$(nth hash 2)" != "$("$scree" hash ./eyes.json --steps 102 --device cpu)" ] || fail "a key of the scene moves nothing"
view 2 ./eyes.json <<<'hold up'
says '"hold up" cannot be done'
view 0 lidar --set robots=400 --set rays=50 <<'END'
frames 3
print
key p
END
[ "$(nth rays 1 | cut -d ' ' -f 1)" -le 3000 ] || fail "too many rays for a software renderer"
says 'of 20050'

# narrow and flat windows: the selection, the panel and the help work in windows of any size
view 0 "${small[@]}" <<'END'
key tab
frames 1
cursor 400 342
frames 1
button down
button up
key tab
size 500 300
frames 3
key F1
frames 3
key w
frames 1
size 64 64
frames 3
print
END
says 'selected crate of body'
rm -f scree-*

# scenes, restart, devices: hashes are equal after a restart and on each device
view 0 "${small[@]}" <<'END'
frames 20
print
key r
frames 20
print
scene billiards
frames 5
print
device auto
frames 5
print
END
[ "$(nth hash 1)" = "$(nth hash 2)" ] || fail "another hash after a restart"
says 'scene billiards, steps 5'
[ "$(nth hash 4)" = "$("$scree" hash billiards --steps 10 --device cpu)" ] || fail "another hash on device auto"
if grep -q '^opencl' <<<"$("$scree" devices)"; then
	view 0 "${small[@]}" <<'END'
frames 10
device opencl
frames 10
print
key h
key d
frames 10
print
END
	[ "$(nth hash 2)" = "$("$scree" hash "${small[@]}" --steps 30 --device cpu)" ] || fail "another hash after OpenCL"
fi

# throwing a body into the scene, single steps, slow motion, saving
view 0 "${small[@]}" <<'END'
cursor 400 100
key t
print
key space
frames 3
print
key n
frames 3
print
key p
key w
key v
key space
frames 10
key v
frames 1
key tab
key F1
key f
key c
key 6
frames 2
END
says 'bodies 8'
[ "$(nth steps 3)" = $(($(nth steps 2) + 1)) ] || fail "n takes not one step"
for file in scree-1.png scree-2.png; do
	[ "$(head -c 4 $file | tail -c 3)" = PNG ] || fail "p and w: $file is not a PNG"
done
command -v ffmpeg >/dev/null && [ ! -s scree-1.mp4 ] && fail "v: there is no video"

# single steps: each key press takes one step, even if several presses come in one frame
view 0 "${small[@]}" <<'END'
frames 4
key space
print
key n
key n
key n
frames 1
print
END
[ "$(nth steps 2)" = $(($(nth steps 1) + 3)) ] || fail "n three times in a frame takes not three steps"

# the time line: each past step has the hash that it had, with every tool, and the steps after it are repeated until the user acts
view 0 pyramid --set rows=8 <<'END'
frames 20
print
cursor 450 100
key t
frames 30
print
hold m
frames 20
print
release m
frames 30
cursor 450 400
button down
frames 5
print
cursor 550 300
frames 25
button up
key x
print
rewind 20
print
rewind 70
print
rewind 50
print
rewind 105
print
rewind 130
print
rewind 106
key ,
frames 1
print
key space
frames 25
print
rewind 60
key t
frames 2
print
rewind 60
rewind 62
print
END
for pair in '1 6' '3 7' '2 8' '4 9' '5 10' '4 11' '5 12' '13 14'; do
	read -r early late <<<"$pair"
	[ "$(nth hash "$early")" = "$(nth hash "$late")" ] && [ "$(nth steps "$early")" = "$(nth steps "$late")" ] ||
		fail "time line: lines $early and $late differ"
done
[ "$(nth bodies 7)" = 46 ] || fail "time line: poured bodies do not come back"
view 2 "${small[@]}" <<<'rewind 9'
says '"rewind 9" cannot be done'
view 0 platformer <<'END'
frames 10
hold right
frames 40
print
release right
frames 60
print
rewind 50
print
key space
key space
frames 60
print
END
[ "$(nth hash 1)" = "$(nth hash 3)" ] && [ "$(nth hash 2)" = "$(nth hash 4)" ] || fail "time line: a character is elsewhere"

# states as files: scree run goes on from them, and the viewer begins with them
rm -f scree-*.snap
view 0 "${small[@]}" <<'END'
cursor 400 100
frames 20
key t
frames 20
key s
frames 10
print
key y
frames 1
print
key space
frames 10
print
END
[ "$(nth hash 1)" = "$(nth hash 3)" ] || fail "a loaded state goes on with another hash"
says 'steps 40'
kept=$(nth hash 1)
"$scree" run "${small[@]}" --device cpu --load scree-1.snap --steps 10 >out 2>err
says "$kept"
view 0 "${small[@]}" --load scree-1.snap <<'END'
key space
frames 10
print
rewind 40
END
[ "$(nth hash 1)" = "$kept" ] || fail "view --load goes on with another hash"
says 'steps 50'
rm -f view.rec
view 0 "${small[@]}" --record view.rec --hash-interval 10 <<'END'
cursor 400 100
frames 20
key t
frames 30
rewind 40
key x
frames 20
print
END
kept=$(nth hash 1)
"$scree" replay view.rec --device cpu >out 2>err || fail "a recording of the viewer differs"
says "$kept"
kept_view=$kept
view 1 "${small[@]}" --record nowhere/view.rec </dev/null
says 'nowhere/view.rec'
echo 'no snapshot' >bad.snap
view 2 "${small[@]}" --load bad.snap </dev/null
says 'are not a snapshot'
view 2 platformer --load scree-1.snap </dev/null
says 'lacks the characters of the scene'
"$scree" run platformer --device cpu --steps 20 --save walk.snap >/dev/null
kept=$("$scree" hash platformer --device cpu --steps 30)
view 0 platformer --load walk.snap <<'END'
key space
frames 10
print
END
[ "$(nth hash 1)" = "$kept" ] || fail "view --load: characters go on with another hash"
view 0 "${small[@]}" <<'END'
key y
print
END
says 'no state has been saved yet'

# recordings: the steps have the hashes of the run; the time line goes to any step, also to later ones; at the end the world pauses.
# The camera, the selection, pictures and saved states work; what changes the world is refused
"$scree" run "${small[@]}" --device cpu --steps 60 --record small.rec --hash-interval 10 >out 2>err || fail "run --record"
early=$("$scree" hash "${small[@]}" --steps 25 --device cpu) late=$("$scree" hash "${small[@]}" --steps 60 --device cpu)
rm -f scree-*
view 0 small.rec <<'END'
frames 25
picture first.png
print
frames 50
print
rewind 25
picture again.png
print
key space
frames 50
print
key r
frames 2
rewind 45
print
rewind 25
key n
key ,
frames 2
print
key tab
frames 1
cursor 400 342
frames 1
button down
button up
button down
cursor 480 300
button up
frames 1
print
wheel 2
key f
key s
rewind 60
print
key n
frames 1
print
END
for line in 1 3 6; do
	[ "$(nth hash $line)" = "$early" ] && [ "$(nth steps $line)" = 25 ] || fail "recording: line $line is not step 25 of the run"
done
for line in 2 4 8 9; do
	[ "$(nth hash $line)" = "$late" ] || fail "recording: line $line is not the end of the run"
done
[ "$(nth steps 5)" = 45 ] || fail "recording: the time line does not go to a later step"
sed -n 2p out | grep -q 'paused, .* says the recording ends after 60 steps; hashes: 7, all equal$' || fail "recording: it does not pause at its end"
sed -n 9p out | grep -q 'paused, .* says the recording ends' || fail "recording: a step after its end"
sed -n 7p out | grep -q 'selected body [0-9]*$' || fail "recording: nothing can be selected"
[ -s scree-1.snap ] || fail "recording: no state is saved"
! [ -x "$build/tests/difference" ] || within first.png again.png 0 0 || fail "recording: pictures of one step differ"
for key in t m x e y delete; do
	view 0 small.rec <<END
frames 2
key $key
print
frames 70
print
END
	says 'says this is a recording, whose calls are only repeated: nothing else changes its world'
	[ "$(nth hash 2)" = "$late" ] || fail "recording: $key changes the world"
done
view 2 small.rec <<<'load scree-1.snap'
says '"load scree-1.snap" cannot be done: this is a recording'
view 0 small.rec <<'END'
frames 3
scene billiards
frames 5
print
scene ./small.rec
frames 25
print
END
[ "$(nth hash 1)" = "$("$scree" hash billiards --steps 5 --device cpu)" ] || fail "recording: another hash in a scene after it"
[ "$(nth hash 2)" = "$early" ] || fail "recording: another hash after a scene"
if grep -q '^opencl' <<<"$("$scree" devices)"; then
	view 0 small.rec <<'END'
frames 10
device opencl
frames 15
print
rewind 5
frames 60
print
END
	[ "$(nth hash 1)" = "$early" ] && [ "$(nth hash 2)" = "$late" ] || fail "recording: another hash after OpenCL"
fi
# bodies that calls of a recording create and replace are shown
"$scree" run churn --set columns=4 --set rows=4 --set moved=2 --set replaced=2 --device cpu --steps 20 --record churn.rec >out 2>err ||
	fail "run --record"
view 0 churn.rec <<'END'
frames 20
print
END
[ "$(nth hash 1)" = "$("$scree" hash churn --set columns=4 --set rows=4 --set moved=2 --set replaced=2 --device cpu --steps 20)" ] ||
	fail "recording: another hash than churn"
# a recording of the viewer, with bodies that were thrown in
view 0 view.rec <<'END'
frames 200
print
END
[ "$(nth hash 1)" = "$kept_view" ] || fail "recording: another hash than the viewer that recorded it"
# a difference is reported as by scree replay; the world pauses there once
if [ -x "$build/tests/changed_recording" ]; then
	"$build/tests/changed_recording" small.rec world_step 25 2 other.rec
	"$scree" replay other.rec --device cpu >out 2>err
	difference=$(sed -n 's/^scree: \(cpu: .*\)/\1/p' err)
	view 1 other.rec <<'END'
frames 60
print
key space
frames 60
print
END
	says "scree view: $difference"
	[[ $difference = 'cpu: scree_replay_step: step 30: the hash is '* ]] || fail "recording: the difference is \"$difference\""
	[ "$(nth steps 1)" = 30 ] && [ "$(nth steps 2)" = 60 ] || fail "recording: it does not pause at the difference"
	says 'says the recording ends after 60 steps; it differs: scree_replay_step: step 30: '
fi
# files that are refused as by scree replay; options that concern a scene
head -c 200 small.rec >cut.rec
head -c 2000 small.rec >short.rec
echo 'no recording' >foreign.rec
: >empty.rec
cp scree-1.snap snapshot.rec
for file in cut short foreign empty snapshot nowhere; do
	"$scree" replay $file.rec --device cpu >out 2>err
	sentence=$(sed 's/^scree\( replay\)\?: //' err)
	view 2 $file.rec </dev/null
	says "scree view: $sentence"
done
head -c "$(($(wc -c <small.rec) - 30))" small.rec >half.rec
view 0 half.rec <<'END'
frames 70
print
END
says ', its end is missing after '
cp small.rec recording # found by its first bytes
view 0 ./recording <<'END'
frames 25
print
END
[ "$(nth hash 1)" = "$early" ] || fail "recording: another name"
for options in '--set rows=3' '--sleep off' '--load scree-1.snap'; do
	# word splitting of $options is intended
	view 2 small.rec $options </dev/null
	says "${options%% *} has no effect: the world is that of a recording"
done

# a key without effect prints the reason
if ! grep -q '^opencl' <<<"$("$scree" devices)"; then
	view 0 "${small[@]}" <<'END'
frames 2
key d
print
END
	says 'says there is no other device than cpu'
fi

# paints: pictures of scree run have the paint of the window, in both themes; the paints of one theme differ from each other
paints=(kind speed solver force origin type)
for k in "${!paints[@]}"; do
	theme=light
	[ $((k % 2)) = 1 ] && theme=dark
	{
		echo 'frames 60'
		for _ in $(seq "$k"); do echo 'key c'; done
		printf 'print\npicture window.png\n'
	} >keys
	view 0 tumbler --set side=12 --theme $theme <keys
	says "painted by ${paints[k]}"
	says ", $theme,"
	# --view shows the view of the scene, 1.5 * (0.36 * 12 + 0.5) m to each side, but leaves out the detail of the scene
	"$scree" run tumbler --set side=12 --device cpu --steps 60 --view -7.23,-7.23,7.23,7.23 --size 800x600 --renderer gl --theme $theme \
		--paint "${paints[k]}" --picture "paint$k.png" >out 2>err || fail "run --paint ${paints[k]}"
	[ -x "$build/tests/difference" ] || continue
	within window.png "paint$k.png" 0.5 0.002 || fail "paint ${paints[k]} in window and picture are not alike"
	[ "$k" -lt 2 ] || { within "paint$k.png" "paint$((k - 2)).png" 0.5 0.002 && fail "paint ${paints[k]} looks like another"; }
done
"$scree" run "${small[@]}" --theme blue --renderer gl --picture blue.png >out 2>err
[ $? = 2 ] || fail "--theme blue: exit code"
says '--theme blue: must be light or dark'
"$scree" view "${small[@]}" --scale 9 >out 2>err
[ $? = 2 ] || fail "--scale 9: exit code"
says '--scale 9: must be a number from 0.5 to 4'
view 0 "${small[@]}" --scale 2 <<'END'
frames 3
key l
frames 2
print
key F1
frames 2
END
says 'dark, panel at 2.00'

# a scene is shown beside the panel, and a few bodies that fly away do not change its scale
view 0 "${small[@]}" <<'END'
frames 2
print
key tab
frames 1
print
key tab
frames 1
print
size 1000 450
frames 3
print
END
[ "$(nth scale 2)" = 60.000 ] || fail "fit: another scale without the panel"
[ "$(nth middle 1)" != "$(nth middle 2)" ] || fail "fit: the panel covers the scene"
[ "$(nth scale 3)" = "$(nth scale 1)" ] || fail "fit: the panel is back, and the scene is not beside it"
[ "$(nth scale 4)" != "$(nth scale 3)" ] || fail "fit: the window has changed, and what it shows has not"
cat >away.json <<'END'
{"name": "away", "title": "One flies away", "attributes": {"floor": {"box": [10, 0.5]}, "ball": {"circle": 0.5}},
"bodies": [
	{"type": "static", "attribute": "floor", "position": [0, -0.5]},
	{"attribute": "ball", "repeat": {"index": "k", "from": 0, "to": 9}, "position": ["k - 4.5", 0.5]},
	{"attribute": "ball", "position": [0, 9], "velocity": [300, 200]}]}
END
view 0 ./away.json <<'END'
frames 60
key f
frames 1
print
END
awk -v scale="$(nth scale 1)" 'BEGIN {exit !(scale > 10)}' || fail "fit: a body that flew away makes all others tiny"

# full screen: the window fills the screen and returns to its size. The display has no window manager, because full screen
# fails with twm
Xvfb -displayfd 4 -screen 0 1280x900x24 4>bare 2>>xvfb.log &
bare=$!
for _ in $(seq 100); do
	[ -s bare ] && break
	sleep 0.1
done
DISPLAY=":$(cat bare)" view 0 "${small[@]}" <<'END'
frames 2
key F11
frames 20
print
key F11
frames 20
print
END
kill $bare
[ "$(nth size 1)" = 1280x900 ] || fail "F11: the window does not fill the screen"
[ "$(nth size 2)" = 800x600 ] || fail "F11: the window is not as it was"

# the view follows the selected body until the user moves the picture
view 0 "${small[@]}" <<'END'
key tab
key k
print
frames 1
cursor 400 342
frames 1
button down
button up
print
key k
frames 30
print
cursor 100 100
button down
cursor 140 100
button up
frames 2
print
END
says 'says nothing is selected that could be followed'
sed -n 3p out | grep -q 'following, ' || fail "k does not follow"
sed -n 4p out | grep -q 'following, ' && fail "who moves the picture still follows"

# explosions, pouring, other scenes
view 0 "${small[@]}" <<'END'
cursor 560 400
frames 2
print
key x
print
frames 3
print
hold m
frames 10
release m
print
frames 10
print
key ]
frames 2
print
key [
frames 2
print
END
grep -q 'says the explosion pushes [1-9][0-9]* shape' out || fail "x: nothing is pushed"
[ "$(nth hash 3)" != "$("$scree" hash "${small[@]}" --steps 5 --device cpu)" ] || fail "x: nothing has moved"
awk -v a="$(nth bodies 3)" -v b="$(nth bodies 4)" 'BEGIN {exit !(b > a && b <= a + 40)}' || fail "m pours nothing, or too much"
[ "$(nth bodies 4)" = "$(nth bodies 5)" ] || fail "m pours when it is up"
[ "$(nth scene 6)" = pyramids ] || fail "] shows not the next scene"
[ "$(nth scene 7)" = pyramid ] || fail "[ shows not the scene before"

# events of the display: wheel, keys, a held body, a moved picture
cat >script <<'END'
key tab
frames 2
print
await paused
print
await running
await holding
print
frames 20
await free
print
await paused
print
END
timeout 120 "$scree" view "${small[@]}" --device cpu --size 800x600 --script script >out 2>err &
viewer=$!
window=$(timeout 30 xdotool search --sync --onlyvisible --name '^scree:' | head -n 1)
# printed N: waits until N lines are printed. By then a frame has handled all earlier input
printed()
{
	for _ in $(seq 300); do
		[ "$(wc -l <out)" = "$1" ] && return
		sleep 0.1
	done
	fail "events: line $1 is missing"
}
moved() { xdotool mousemove --window "$window" "$@"; }
printed 1
xdotool windowfocus "$window"
moved 400 500
sleep 0.3 # the panel handles in the next frame that the cursor has left it
xdotool click 4 click 4 click 5 key space
printed 2
xdotool key f key space
moved 400 222 mousedown 1
printed 3
moved 500 150
sleep 0.5
xdotool mouseup 1
printed 4
moved 700 100 mousedown 1
moved 650 100
xdotool mouseup 1 key space
wait $viewer || fail "events: exit code $?"
[ "$(nth scale 2)" = 69.000 ] || fail "events: two turns of the wheel and one back are not 1.15"
[ "$(nth steps 4)" -gt "$(nth steps 2)" ] || fail "events: space does not go on"
[ "$(nth hash 4)" != "$("$scree" hash "${small[@]}" --steps "$(nth steps 4)" --device cpu)" ] ||
	fail "events: the hand has moved nothing"
[ "$(nth middle 5)" != "$(nth middle 4)" ] || fail "events: the picture does not follow the mouse"

# input of the display: a click selects a body, Escape ends the selection, and keys of the scene push while they are down
cat >script <<'END'
key tab
frames 2
print
await selected
print
await unselected
await pushing
frames 20
print
await pushed
print
END
timeout 120 "$scree" view ./eyes.json --device cpu --size 800x600 --script script >out 2>err &
viewer=$!
window=$(timeout 30 xdotool search --sync --onlyvisible --name '^scree:' | head -n 1)
printed 1
xdotool windowfocus "$window"
moved 400 500 # the floor
sleep 0.3
xdotool click 1
printed 2
xdotool key Escape keydown Right
printed 3
xdotool keyup Right
wait $viewer || fail "keys: exit code $?"
[ "$(nth selected 2)" = 'floor of body 1' ] || fail "keys: a click selects something else"
sed -n 3p out | grep -q selected && fail "keys: Escape does not forget"
[ "$(wc -l <out)" = 4 ] || fail "keys: a key that was let go still pushes"
[ "$(nth hash 3)" != "$("$scree" hash ./eyes.json --steps "$(nth steps 3)" --device cpu)" ] || fail "keys: nothing was pushed"

# the time line in the panel: dragged to its middle
cat >script <<'END'
frames 60
key space
print
await running
print
END
timeout 120 "$scree" view billiards --device cpu --size 800x700 --script script >out 2>err &
viewer=$!
window=$(timeout 30 xdotool search --sync --onlyvisible --name '^scree:' | head -n 1)
printed 1
xdotool windowfocus "$window"
moved 280 132 mousedown 1
for x in 250 200 160; do
	moved $x 132
	sleep 0.2
done
xdotool mouseup 1 key space
wait $viewer || fail "time line: exit code $?"
steps=$(nth steps 2)
[ "$steps" -gt 20 ] && [ "$steps" -lt 45 ] || fail "time line: the middle of 60 steps is step $steps"
[ "$(nth hash 2)" = "$("$scree" hash billiards --steps "$steps" --device cpu)" ] || fail "time line: step $steps has another hash"

# the panel: a parameter and a paint of the same name have different fields
cat >script <<'END'
frames 5
print
await speed
print
END
timeout 120 "$scree" view billiards --device cpu --size 800x700 --script script >out 2>err &
viewer=$!
window=$(timeout 30 xdotool search --sync --onlyvisible --name '^scree:' | head -n 1)
printed 1
xdotool windowfocus "$window"
moved 60 83 click --repeat 2 --delay 200 1 # the field "speed"
xdotool key --delay 100 6 0 Return
moved 126 595 click 1 # the paint "speed"
wait $viewer || fail "panel: exit code $?"
says 'painted by speed'

# keys and clicks during a long frame are not lost: a field of the panel gets them in order
cat >script <<'END'
frames 5
print
await paused
frames 40
print
await running
END
timeout 120 "$scree" view billiards --device cpu --size 800x700 --script script >out 2>err &
viewer=$!
window=$(timeout 30 xdotool search --sync --onlyvisible --name '^scree:' | head -n 1)
printed 1
xdotool windowfocus "$window"
sleep 0.3
frozen=$(pgrep -P $viewer)
kill -STOP "$frozen"
moved 60 83 click --repeat 2 --delay 20 1 key --delay 5 9 BackSpace 6 0 Return
moved 600 100 click 1 key space
sleep 0.2
kill -CONT "$frozen"
timeout 30 xdotool search --sync --name '^scree: billiards .paused.' >out.titles 2>&1 || fail "frozen: the title does not say that it is paused"
xdotool key space
wait $viewer || fail "frozen: exit code $?"
[ "$(nth hash 2)" = "$("$scree" hash billiards --set speed=60 --steps "$(nth steps 2)" --device cpu)" ] ||
	fail "frozen: what was typed into the panel is lost"

# a video ends when the window changes its size, and a tiny window does not damage the camera
if command -v ffmpeg >/dev/null; then
	rm -f scree-*
	view 0 "${small[@]}" <<'END'
key tab
frames 2
key v
frames 10
key space
size 200 150
frames 5
key p
key space
frames 10
size 10 10
frames 5
key f
frames 2
size 800 600
frames 5
key f
print
END
	[ -s scree-1.mp4 ] || fail "a video in a window that changes its size is lost"
	[ -s err ] && fail "a video in a window that changes its size: a complaint"
	[ "$(nth scale 1)" = 60.000 ] || fail "a tiny window spoils the camera"
fi

# minimizes the window, restores it and changes its size
kill -0 $manager || { cat twm.log; failures=$((failures + 1)); }
view 0 "${small[@]}" <<'END'
frames 2
minimize
await minimized
frames 3
restore
await restored
size 300 200
frames 5
picture small.png
size 1200 800
frames 5
print
END
[ "$(nth hash 1)" = "$("$scree" hash "${small[@]}" --steps "$(nth steps 1)" --device cpu)" ] || fail "another hash than scree hash"

# refusals
view 2 "${small[@]}" <<'END'
frames 2
dance
END
says 'script:2: "dance" cannot be done'
view 2 "${small[@]}" <<<'device nothing'
says '"device nothing" cannot be done: '
view 2 "${small[@]}" <<<'wheel nan'
view 2 "${small[@]}" <<<'cursor inf 0'
view 2 nothing </dev/null
says 'no scene is called "nothing"'
view 1 "${small[@]}" <<<'picture nowhere/picture.png'
says 'cannot write nowhere/picture.png'
MESA_GL_VERSION_OVERRIDE=2.1 view 1 "${small[@]}" </dev/null
says 'there is no OpenGL 3.3 on this display'
DISPLAY=:9999 view 1 "${small[@]}" </dev/null
says 'there is no display to open a window on'
DISPLAY='' view 1 "${small[@]}" </dev/null
says 'there is no display to open a window on'
"$scree" view "${small[@]}" --script missing >out 2>err
[ $? = 2 ] || fail "a missing script: exit code"
says 'cannot read missing'

echo "$failures failures"
[ "$failures" = 0 ]
