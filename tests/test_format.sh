#!/usr/bin/env bash
# test_format.sh -- checks that clang-format 14 would change no C file.
set -euo pipefail
cd "$SCREE_SOURCE"

format=$(command -v clang-format-14 || true)
if [ -z "$format" ] && clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
	format=clang-format
fi
if [ -z "$format" ]; then
	echo "skipped: clang-format 14 is not installed"
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
