#!/usr/bin/env bash
# test_format.sh -- checks that clang-format would change no C file; 14, 17, 18 and 19 agree about this tree.
set -euo pipefail
cd "$SCREE_SOURCE"

format=clang-format
version=$($format --version 2>/dev/null | sed -n 's/.*version \([0-9]*\)\..*/\1/p')
if [ "${version:-0}" -lt 14 ]; then
	echo "skipped: clang-format 14 or later is not installed"
	exit 77
fi
if ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
	echo "skipped: not a git checkout, so there is no list of files"
	exit 77
fi
says=$(git ls-files -z --cached --others --exclude-standard '*.c' '*.h' | xargs -0 "$format" --dry-run 2>&1) ||
	{ echo "$says"; exit 1; }
bad=$(sed -n 's/^\([^:]*\):[0-9]*:[0-9]*: warning: code should be clang-formatted.*/\1/p' <<<"$says" | sort | uniq -c)
[ -z "$bad" ] || { printf 'places to format (make format does it):\n%s\n' "$bad"; exit 1; }
