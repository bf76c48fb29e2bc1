#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# lists.sh -- writes the files that are generated from lists of the sources.
#
# usage: tools/lists.sh TESTS [FOLDER]
#   TESTS   folder of the test programs, which contains scene_lists
#   FOLDER  gets scenes/scene.schema.json and docs/scenes.md with its tables; default the sources
set -euo pipefail
. "${BASH_SOURCE[0]%/*}/usage.sh"
source=${BASH_SOURCE[0]%/*}/..
program=${1:?is the folder of the test programs}/scene_lists
folder=${2:-$source}

mkdir -p "$folder/scenes" "$folder/docs"
schema=$("$program" schema)
document=$(
	sed '/^<!-- tables by make lists -->$/q' "$source/docs/scenes.md"
	"$program" tables
	sed -n '/^<!-- end of tables -->$/,$p' "$source/docs/scenes.md"
)
echo "$schema" >"$folder/scenes/scene.schema.json"
echo "$document" >"$folder/docs/scenes.md"
