#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_reference.sh -- builds the reference of the public interface, which fails if a function has no comment, and checks that
# it has a page for each part of the header and an entry of the search for each function.
set -uo pipefail
source=${SCREE_SOURCE:?is the folder of the sources}
build=${SCREE_BUILD:?is the build folder}
command -v doxygen >/dev/null || { echo "skipped: there is no doxygen"; exit 77; }
folder=$(mktemp -d "$build/test_reference.XXXXXX")
trap 'rm -rf "$folder"' EXIT
"$source/tools/reference.sh" "$source" "$folder" || exit 1
failures=0
while read -r name; do
	grep -q "\"$name\"\|'$name'" "$folder"/search/functions_*.js || { echo "FAILED: the search lacks $name"; failures=1; }
done < <(sed -n 's/^SCREE_API .*[ *]\(scree_[a-z0-9_]*\)(.*/\1/p' "$source/include/scree/scree.h" | grep -v _sized)
parts=$(grep -c '@defgroup' <(awk -f "$source/tools/reference.awk" "$source/include/scree/scree.h"))
pages=$(find "$folder" -name 'group__group*.html' | wc -l)
[ "$parts" -eq "$pages" ] || { echo "FAILED: $pages pages of $parts parts"; failures=1; }
[ $failures -eq 0 ] && echo "$parts parts"
exit $failures
