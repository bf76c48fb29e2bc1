#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_page.sh -- checks the page in Chromium: hashes of all scenes in three builds, pictures, mouse and fingers, links,
# and the comparison of hashes.
set -uo pipefail
scree=${SCREE_BINARY:?is the path of the command line}
build=${SCREE_BUILD:?is the build folder}
source=${SCREE_SOURCE:?is the folder of the sources}
# skip REASON...: skips the test, or fails if SCREE_EXPECT requires the page
skip()
{
	echo "skipped: $*"
	[[ " ${SCREE_EXPECT:-} " = *" web "* ]] && exit 1
	exit 77
}
[ -x "$scree" ] || skip "no command line was built"
"$scree" run --help | grep -q -e '--renderer' || skip "this build does not draw with OpenGL, which the pictures are compared with"
for tool in node chromedriver chromium; do
	command -v "$tool" >/dev/null || skip "there is no $tool; Debian has it in nodejs, chromium-driver and chromium"
done
for form in scalar simd threads; do
	[ -f "$source/build/wasm-$form/scree-$form.wasm" ] || skip "build/wasm-$form has no scree-$form.wasm: make web builds it"
done
cd "$source" || exit 1
scratch=$(mktemp -d "$build/test_page.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
node web/make_page.mjs "$scree" "$source/build" "$scratch/page" && node tests/page/main.mjs "$scree" "$scratch/page" "$scratch"
