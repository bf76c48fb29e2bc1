#!/bin/sh
# SPDX-License-Identifier: MIT
# one_file.sh -- writes the CPU library as one C file, with the public headers: FOLDER/scree_all.c and FOLDER/scree/*.h.
#
# usage: tools/one_file.sh FOLDER
set -eu
. "$(dirname "$0")/usage.sh"
folder=${1:?is the folder of the output}
mkdir -p "$folder/scree"
folder=$(cd "$folder" && pwd)
cd "$(dirname "$0")/.."

host=$(find src -name '*.c' | LC_ALL=C sort | grep -v -e '^src/opencl/' -e '/one_thread\.c$' -e '^src/cpu/lanes[0-9]*\.c$' -e '/scalar_avx2\.c$')
{
	sed 's,^,// ,; s, *$,,' LICENSE
	# the list of files must be split into words
	awk -v root=. -f tools/one_file.awk $host src/cpu/lanes1.c src/cpu/lanes4.c src/cpu/scalar_avx2.c src/cpu/lanes8.c src/cpu/lanes16.c
} >"$folder/scree_all.c.new"
cp include/scree/scree.h include/scree/scree_math.h "$folder/scree/"
mv "$folder/scree_all.c.new" "$folder/scree_all.c"
