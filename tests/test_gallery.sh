#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_gallery.sh -- runs tools/gallery.sh on two small scenes, and checks its files, the text of the page, and an
# unknown scene.
set -uo pipefail
scree=${SCREE_BINARY:?is the path of the command line}
build=${SCREE_BUILD:?is the build folder}
source=${SCREE_SOURCE:?is the folder of the sources}
[ -x "$scree" ] || { echo "skipped: no command line was built"; exit 77; }
for tool in ffmpeg jq; do
	command -v $tool >/dev/null || { echo "skipped: there is no $tool"; exit 77; }
done
folder=$(mktemp -d "$build/test_gallery.XXXXXX")
trap 'rm -rf "$folder"' EXIT
"$scree" run slope --device cpu --steps 1 --picture "$folder/probe.png" >/dev/null 2>&1 || { echo "skipped: this build draws no pictures"; exit 77; }
export SCREE=$scree SIZE=320x180 CLIP_SIZE=160x90 SHOWN=0.1
failures=0
fail()
{
	echo "FAILED: $*"
	sed 's/^/    | /' "$folder/out" "$folder/err"
	failures=$((failures + 1))
}

# 0.1 s is 6 steps in both scenes
timeout 300 bash "$source/tools/gallery.sh" "$folder/page" slope gears >"$folder/out" 2>"$folder/err" || fail "gallery.sh: exit code $?"
page=$folder/page/index.html
for scene in slope gears; do
	for ending in png jpg mp4; do
		[ -s "$folder/page/$scene.$ending" ] || fail "no $scene.$ending"
		grep -q "\"$scene.$ending\"" "$page" || fail "the page shows no $scene.$ending"
	done
	hash=$("$scree" hash $scene --device cpu --steps 6)
	grep -q "step 6 .*<code>$hash</code>" "$page" || fail "$scene: another step or hash than $hash"
	grep -qF "<pre>build/scree run $scene --steps 6 --picture $scene.png --size 320x180</pre>" "$page" || fail "$scene: no command"
	grep -qF "$(jq -r .title "$source/scenes/$scene.json")" "$page" || fail "$scene: no title"
	# a clip with few steps is played slowly, so that it lasts 2.5 to 5 s
	seconds=$(ffprobe -v error -show_entries format=duration -of csv=p=0 "$folder/page/$scene.mp4")
	awk -v s="$seconds" 'BEGIN { exit !(s >= 2.5 && s <= 5) }' || fail "$scene: the clip lasts $seconds s"
done
grep -q '<td>degrees<td>25<td>of the slopes' "$page" || fail "slope: no parameters"
grep -qi '<script\|http' "$page" && fail "the page has a script or an address"

# an unknown scene is an error, and the other scenes are still drawn
timeout 300 bash "$source/tools/gallery.sh" "$folder/other" slope nowhere >"$folder/out" 2>"$folder/err"
[ $? = 1 ] || fail "an unknown scene: no failure"
grep -q 'there is no scene nowhere' "$folder/err" || fail "an unknown scene: no sentence"
grep -q 'slope.png' "$folder/other/index.html" || fail "an unknown scene: no page of the others"

[ $failures = 0 ] && echo "the gallery is as it should be"
exit $((failures > 0))
