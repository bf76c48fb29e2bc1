#!/usr/bin/env bash
# test_docs.sh -- the documents tell the truth about paths, kernels, words and the first program.
set -euo pipefail
cd "$SCREE_SOURCE"
failed=0
complain()
{
	echo "$*"
	failed=1
}

# whatever stands in back quotes and looks like a path of this repository is there; a * may stand for files of one kind
for document in README.md ARCHITECTURE.md STYLE.md CHANGELOG.md CONTRIBUTING.md SECURITY.md .github/*.md docs/*.md; do
	while read -r path; do
		compgen -G "${path%/}" >/dev/null || complain "$document: \`$path\` does not exist"
	done < <(sed '/^```/,/^```/d' "$document" | grep -o '`[^` ]*`' | tr -d '`' |
		grep -E '^(\.ci|\.github|bench|cli|cmake|docs|examples|include|scene|scenes|src|tests|tools|validate|view)/|^[A-Za-z_]+\.(md|json|txt)$|^(Makefile|LICENSE)$' | sort -u)
	folder=$([[ $document = */* ]] && echo "${document%/*}" || echo .)
	while read -r path; do
		[ -e "$folder/$path" ] || complain "$document: the link to $path leads nowhere"
	done < <(sed '/^```/,/^```/d' "$document" | grep -oE '\]\([^)#]+' | cut -c 3- | grep -v '^https\?:' | sort -u)
done

# the index has each page once, because a page has one reader
for page in docs/*.md; do
	page=${page#docs/}
	[ "$page" = README.md ] || [ "$(grep -c "^| \[$page\]($page) |" docs/README.md)" = 1 ] ||
		complain "docs/README.md: $page must have one row"
done

# the README shows the first program as it is
sed -n '/^```c$/,/^```$/p' README.md | sed '1d;$d' | diff -u examples/hello.c - ||
	complain "README.md: its program is not examples/hello.c"

# every kernel has its line in docs/step.md, those of a kind of constraint for each kind
steps=$(<docs/step.md)
while read -r kernel; do
	[[ $steps = *"\`$kernel\`"* ]] || complain "docs/step.md: kernel $kernel is missing"
done < <(sed -nE 's/^CONSTRAINT_KIND\(([a-z]+),.*/\1/p' src/pools/kinds.def | while read -r kind; do
	sed -nE -e '/^\/\//d' -e "s/kind##/$kind/" -e 's/^.*X\(([a-z_0-9]*),.*/\1/p' src/stages/kernels.def
done | sort -u)

# every word of the dialect has its line in docs/dialect.md, but for what only other words use
words=$(<docs/dialect.md)
while read -r word; do
	[[ $words = *"\`$word"[\`\(]* ]] || complain "docs/dialect.md: the word $word is missing"
done < <(sed -nE -e 's/^#define ([A-Za-z_0-9]+).*/\1/p' -e 's/^INLINE [A-Za-z0-9]+\*? ([a-z_0-9]+)\(.*/\1/p' \
	-e 's/^typedef .*[ }]([A-Z][A-Za-z0-9]*)( __attribute__.*)?;.*/\1/p' src/dialect/{dialect,opencl_words,c_words,wide}.h |
	grep -vxE '(DIALECT|OPENCL_WORDS|C_WORDS|WIDE)_H|ROW|KERNEL_JOIN_?' | sort -u)

# every key of the viewer has its row in docs/view.md
while read -r key; do
	grep -qE "^\|.*\`$key\`.*\|" docs/view.md || complain "docs/view.md: the key $key is missing"
done < <(sed -nE 's/^X\([a-z]+, [A-Z0-9]+, "([^"]+)".*/\1/p' view/window/keys.def)

# only one file of the stages asks which compiler is reading it
asks=$(grep -rlE "__OPENCL|__GNUC__|__clang__" src/stages src/constraints src/pools | tr '\n' ' ' || true)
[ -z "$asks" ] || complain "only src/dialect/dialect.h asks which compiler reads it: $asks"

# every file says what it is
while read -r file; do
	complain "$file: does not begin with its licence and what it is"
done < <(find include src cli scene tools validate view tests examples \( -name '*.c' -o -name '*.h' \) -print0 | xargs -0 awk '
	FNR == 1 { if (last && !good) print last; last = FILENAME; first = $0; good = 0 }
	FNR == 2 { name = FILENAME; sub(".*/", "", name); good = first $0 ~ "^// SPDX-License-Identifier: MIT// " name " -- " }
	END { if (last && !good) print last }')
exit $failed
