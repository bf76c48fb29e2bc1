#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# lists.sh -- writes the files that are generated from lists in the sources.
#
# usage: tools/lists.sh TESTS [FOLDER]
#   TESTS   folder of the test programs, which contains scene_lists
#   FOLDER  folder for scenes/scene.schema.json, docs/manual/scenes.md and docs/manual/view.md; default: the sources
set -euo pipefail
. "${BASH_SOURCE[0]%/*}/usage.sh"
source=${BASH_SOURCE[0]%/*}/..
program=${1:?is the folder of the test programs}/scene_lists
folder=${2:-$source}

# replace NAME COMMAND...: copies a document from standard input to standard output; between the marks NAME, the output of the
# command replaces the text
replace()
{
	local name=$1 document
	document=$(cat)
	sed "/^<!-- $name by make lists -->\$/q" <<<"$document"
	"${@:2}"
	sed -n "/^<!-- end of $name -->\$/,\$p" <<<"$document"
}

keys()
{
	printf '%s\n' '| key | in | what it does |' '| --- | --- | --- |'
	sed -nE -e 's/^X\(.*, "(.+)", "(.+)"\)$/| `\1` | viewer, page | \2 |/p' \
		-e 's/^VIEWER\(.*, "(.+)", "(.+)"\)$/| `\1` | viewer | \2 |/p' \
		-e 's/^PAGE\(.*, "(.+)", "(.+)"\)$/| `\1` | page | \2 |/p' \
		-e 's/^MOUSE\("(.+)", "(.+)"\)$/| \1 | viewer, page | \2 |/p' "$source/view/window/keys.def"
}
layers()
{
	printf '%s\n' '| layer | key | what it shows |' '| --- | --- | --- |'
	sed -nE 's/^X\(([a-z]+), .*, "(.+)", "(.+)"\)$/| `\1` | `\2` | \3 |/p' "$source/view/layers.def"
}
paints()
{
	printf '%s\n' '| paint | what a color means |' '| --- | --- |'
	sed -nE 's/^X\([A-Z]+, "(.+)", "(.+)"\)$/| `\1` | \2 |/p' "$source/view/paints.def"
}

mkdir -p "$folder/scenes" "$folder/docs/manual"
schema=$("$program" schema)
scenes=$(replace tables "$program" tables <"$source/docs/manual/scenes.md")
view=$(replace keys keys <"$source/docs/manual/view.md" | replace layers layers | replace paints paints)
echo "$schema" >"$folder/scenes/scene.schema.json"
echo "$scenes" >"$folder/docs/manual/scenes.md"
echo "$view" >"$folder/docs/manual/view.md"
