#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# gallery.sh -- draws scenes as pictures and short clips, and writes a page that shows them: FOLDER/index.html.
#
# usage: tools/gallery.sh FOLDER [SCENE...]
#   FOLDER  folder for index.html and, for each scene, NAME.png, NAME.jpg and NAME.mp4
#   SCENE   name of a scene in scenes/; default: all scenes
# Variables and their defaults:
#   SCREE      path of the command line (build/scree)
#   SIZE       size of pictures, px (1600x900)
#   CLIP_SIZE  size of clips, px (640x360)
#   SHOWN      simulated seconds in a clip (4)
#   WORK       maximum of (bodies + rays) x steps (25000000), so that a scene of a million bodies has few steps
# Needs ffmpeg and jq. Exit 1 if a scene fails; the page then has the other scenes.
set -uo pipefail
. "$(dirname "$0")/../tools/usage.sh"
cd "$(dirname "$0")/.." || exit 1
folder=${1:?is the folder for the page}
shift
scree=${SCREE:-build/scree} size=${SIZE:-1600x900} clip_size=${CLIP_SIZE:-640x360} shown=${SHOWN:-4} work=${WORK:-25000000}
least=3 # s; a shorter clip is slowed down to this length
for tool in ffmpeg jq; do
	command -v $tool >/dev/null || { echo "gallery.sh: $tool was not found (Debian: apt install $tool)" >&2; exit 1; }
done
[ $# -gt 0 ] || mapfile -t names < <("$scree" scenes --names) && [ $# -eq 0 ] && set -- "${names[@]}"
mkdir -p "$folder" || exit 1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# result NAME: prints the value of the row NAME in the table that scree run printed
result()
{
	awk -v name="$1" '$1 == name { print $2; exit }' "$scratch/table"
}

# least_of A B...: prints the least of some whole numbers
least_of()
{
	printf '%s\n' "$@" | sort -n | head -n 1
}

# draw NAME: draws the picture and the clip of a scene; sets the variables steps, bodies and hash
draw()
{
	local name=$1 file=scenes/$1.json dt rays slower
	dt=$(awk "BEGIN { print $(jq -r '.world.dt // "1 / 60"' "$file") }")
	"$scree" run "$name" --device cpu --steps 1 >"$scratch/table" || return 1
	bodies=$(result bodies) rays=$(result rays)
	steps=$(least_of "$(awk "BEGIN { printf \"%.0f\", $shown / $dt }")" "$(jq '.steps // 300' "$file")" $((work / (bodies + ${rays:-0} + 1) + 1)))
	"$scree" run "$name" --device cpu --steps "$steps" --picture "$folder/$name.png" --size "$size" >"$scratch/table" || return 1
	hash=$(result hash)
	"$scree" run "$name" --device cpu --steps "$steps" --video "$scratch/clip.mp4" --size "$clip_size" >"$scratch/table" || return 1
	[ "$(result hash)" = "$hash" ] || { echo "gallery.sh: $name: the picture and the clip have different hashes" >&2; return 1; }
	slower=$(awk "BEGIN { t = $steps * $dt; print t < $least ? $least / t : 1 }")
	ffmpeg -loglevel error -y -i "$scratch/clip.mp4" -vf "setpts=$slower*PTS,fps=30" -c:v libx264 -crf 28 -preset slow -pix_fmt yuv420p \
		-movflags +faststart "$folder/$name.mp4" </dev/null &&
		ffmpeg -loglevel error -y -i "$folder/$name.png" -vf 'scale=min(iw\,960):-2' -q:v 4 "$folder/$name.jpg" </dev/null
}

# card NAME: prints the section of the page that shows a scene
card()
{
	jq -r --arg name "$1" --arg steps "$steps" --arg bodies "$bodies" --arg hash "$hash" --arg size "$size" '
		def row: "<tr><td>\(.key | @html)<td>\(.value.default | tostring | @html)<td>\(.value.description // "" | @html)";
		(.title | @html) as $title | (.parameters // {} | to_entries) as $parameters |
		"<section id=\"\($name)\"><h2>\($name)</h2><p>\($title)</p><div class=\"pair\">",
		"<a href=\"\($name).png\"><img src=\"\($name).jpg\" loading=\"lazy\" alt=\"\($title): step \($steps)\"></a>",
		"<video src=\"\($name).mp4\" poster=\"\($name).jpg\" autoplay loop muted playsinline controls></video></div>",
		"<p>step \($steps) · \($bodies) bodies · hash <code>\($hash)</code></p>",
		"<pre>build/scree run \($name) --steps \($steps) --picture \($name).png\(if $size == "1600x900" then "" else " --size " + $size end)</pre>",
		(if $parameters == [] then empty else
			"<details><summary>parameters</summary><table><tr><th>name<th>default<th>description", ($parameters[] | row), "</table></details>" end),
		"</section>"' "scenes/$1.json"
}

failed=0
for name in "$@"; do
	[ -e "scenes/$name.json" ] || { echo "gallery.sh: there is no scene $name in scenes/" >&2; failed=1; continue; }
	begin=$SECONDS
	if draw "$name"; then
		card "$name" >>"$scratch/cards"
		echo "$name: step $steps, $((SECONDS - begin)) s"
	else
		echo "gallery.sh: $name failed" >&2
		failed=1
	fi
done
[ -e "$scratch/cards" ] || exit 1

{
	cat <<-'PAGE'
		<!DOCTYPE html>
		<html lang="en">
		<meta charset="utf-8">
		<meta name="viewport" content="width=device-width, initial-scale=1">
		<title>Scree: all scenes</title>
		<style>
		:root { color-scheme: light dark; --ink: #33312d; --faint: #6d6960; --page: #f7f5f0; --card: #fff; --line: #dedad0; --link: #a8452c }
		@media (prefers-color-scheme: dark) {
			:root { --ink: #e6e2d9; --faint: #a39e93; --page: #1b1a18; --card: #262421; --line: #3b3833; --link: #f0a074 }
		}
		* { box-sizing: border-box }
		body { margin: 0 auto; padding: 1rem; max-width: 84rem; font: 1rem/1.5 system-ui, sans-serif; color: var(--ink); background: var(--page) }
		a { color: var(--link) }
		h1 { margin: 1rem 0 .25rem } h2 { margin: 0; font-size: 1.25rem }
		nav { display: flex; flex-wrap: wrap; gap: .25rem .75rem; margin: 1rem 0 }
		section { margin: 1.25rem 0; padding: 1rem; background: var(--card); border: 1px solid var(--line); border-radius: .5rem }
		section p { margin: .25rem 0 .75rem; color: var(--faint); overflow-wrap: anywhere }
		.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); gap: .75rem; margin-bottom: .75rem }
		img, video { display: block; width: 100%; height: auto; border-radius: .25rem; background: #f7f5f0 }
		pre { margin: 0; padding: .5rem .75rem; white-space: pre-wrap; border: 1px solid var(--line); border-radius: .25rem; font-size: .85rem }
		details { margin-top: .5rem } summary { cursor: pointer; color: var(--faint) }
		table { border-collapse: collapse; font-size: .9rem } th, td { padding: .15rem 1rem .15rem 0; text-align: left; vertical-align: top }
		</style>
		<h1>Scree: all scenes</h1>
	PAGE
	echo "<p>Pictures and clips by Scree $("$scree" --version). Below each is the command that made the picture, and the hash of the world at that" \
		"step: the same bits on every CPU and GPU. A click shows a picture in full size.</p>"
	echo '<nav>'
	sed -n 's/^<section id="\([^"]*\)">.*/<a href="#\1">\1<\/a>/p' "$scratch/cards"
	echo '</nav>'
	cat "$scratch/cards"
	echo '</html>'
} >"$folder/index.html" || exit 1
echo "The page is $folder/index.html"
exit $failed
