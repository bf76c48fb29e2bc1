#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_scene_files.sh -- writes worlds of scenes as scene files by the command line, and checks the files by the schema and by
# loading them.
set -euo pipefail
[ -x "$SCREE_BINARY" ] || { echo "skipped: there is no command line"; exit 77; }
folder=$(mktemp -d "$SCREE_BUILD/test_scene_files.XXXXXX")
trap 'rm -rf "$folder"' EXIT
cd "$folder"

for scene in alarm-clock billiards bridge coaster drift gears machine platformer pond ragdolls shapes storm wrecking-ball; do
	"$SCREE_BINARY" run "$scene" --device cpu --steps 40 --write-scene "$scene.json" >/dev/null
	"$SCREE_BINARY" hash "$scene.json" --device cpu --steps 20 >/dev/null
done

# The module jsonschema of Python is optional.
if python3 -c 'import jsonschema' 2>/dev/null; then
	python3 - "$SCREE_SOURCE/scenes/scene.schema.json" *.json <<'PYTHON'
import json, sys
from jsonschema import Draft202012Validator

validator = Draft202012Validator(json.load(open(sys.argv[1])))
for path in sys.argv[2:]:
    for error in validator.iter_errors(json.load(open(path))):
        sys.exit(f"{path}: {list(error.absolute_path)}: {error.message[:200]}")
print(f"{len(sys.argv) - 2} files are valid by the schema")
PYTHON
fi
