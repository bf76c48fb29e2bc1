#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_lists.sh -- checks that the command "make lists" would change no file. It generates files from lists of the
# sources.
set -euo pipefail
[ -x "$SCREE_BUILD/tests/scene_lists" ] || { echo "skipped: scenes need Jansson"; exit 77; }
folder=$(mktemp -d "$SCREE_BUILD/test_lists.XXXXXX")
trap 'rm -rf "$folder"' EXIT
bash "$SCREE_SOURCE/tools/lists.sh" "$SCREE_BUILD/tests" "$folder"
for file in scenes/scene.schema.json docs/manual/scenes.md docs/manual/view.md; do
	diff -u "$SCREE_SOURCE/$file" "$folder/$file" || { echo "$file: make lists writes it"; exit 1; }
done
