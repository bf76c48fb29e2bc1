#!/usr/bin/env bash
# test_docs.sh -- checks documents: paths, kernels, words of the dialect and the first program. Also checks the first
# words of comments, and the paths in comments.
set -euo pipefail
cd "$SCREE_SOURCE"
failed=0
complain()
{
	echo "$*"
	failed=1
}

# each text in back quotes that looks like a path of this repository must be a path that exists; it may contain a *
for document in README.md ARCHITECTURE.md STYLE.md CHANGELOG.md CONTRIBUTING.md SECURITY.md .github/*.md docs/*.md docs/*/*.md; do
	while read -r path; do
		compgen -G "${path%/}" >/dev/null || complain "$document: \`$path\` does not exist"
	done < <(sed '/^```/,/^```/d' "$document" | grep -o '`[^` ]*`' | tr -d '`' |
		grep -E '^(\.ci|\.github|bench|cli|cmake|docs|examples|include|mpi|scene|scenes|src|tests|tools|validate|view|web)/|^[A-Za-z_]+\.(md|json|txt)$|^(Makefile|LICENSE)$' | sort -u)
	folder=$([[ $document = */* ]] && echo "${document%/*}" || echo .)
	while read -r path; do
		[ -e "$folder/$path" ] || complain "$document: the link to $path leads nowhere"
	done < <(sed '/^```/,/^```/d' "$document" | grep -oE '\]\([^)#]+' | cut -c 3- | grep -v '^https\?:' | sort -u)
done

# two indexes list each page once: docs/manual/README.md those of its folder, docs/README.md all others
for page in docs/*.md docs/*/*.md; do
	[[ $page != */README.md ]] || continue
	index=$([[ $page = docs/manual/* ]] && echo docs/manual || echo docs)
	path=${page#"$index"/}
	[ "$(grep -c "^| \[[^]]*\]($path) |" "$index/README.md")" = 1 ] || complain "$index/README.md: $path must have one row"
done

# the program of the README is a part of the first program
excerpt=$(sed -n '/^```c$/,/^```$/p' README.md | sed -e '1d;$d' -e 's/^./\t&/')
[[ -n $excerpt && $(<examples/hello.c) = *"$excerpt"* ]] || complain "README.md: its program is not a part of examples/hello.c"

# the README and the page have one address of the project, so that one command replaces it (CONTRIBUTING.md, "A release")
address=$(sed -n 's/.*"source": "\([^"]*\)".*/\1/p' web/start.json)
while read -r link; do
	[[ $link = "$address"* ]] || complain "README.md: $link does not begin with $address, the address in web/start.json"
done < <(grep -oE 'https?://[^) ]*' README.md)

# each program or part of one in docs/first_game.md is in a file of examples/first_game/, unchanged
parts=$(cat examples/first_game/*.[ch])
fragments=0
while IFS= read -r -d $'\f' fragment; do
	[[ $parts == *"${fragment%$'\n'}"* ]] || complain "docs/first_game.md: not in examples/first_game/: $fragment"
	fragments=$((fragments + 1))
done < <(awk '/^```c$/ { inside = 1; next } /^```$/ && inside { inside = 0; printf "\f"; next } inside' docs/first_game.md)
[ "$fragments" -gt 10 ] || complain "docs/first_game.md: only $fragments parts of programs were found"

# exists PATH FOLDER: succeeds if PATH exists relative to the root, to src/ or to FOLDER.
exists()
{
	compgen -G "${1%/}" >/dev/null || compgen -G "src/${1%/}" >/dev/null || compgen -G "$2/${1%/}" >/dev/null
}

# each of these folders has a README, in which a table names the files for each kind of change; these files exist
for folder in bench cli mpi scene tests view web src/*/; do
	document=${folder%/}/README.md
	[ -e "$document" ] || { complain "$document: does not exist"; continue; }
	while read -r path; do
		exists "$path" "${folder%/}" || complain "$document: \`$path\` does not exist"
	done < <(grep -o '`[^` ]*`' "$document" | tr -d '`' |
		grep -E '\.(awk|c|cl|cmake|cpp|def|frag|glsl|h|html|js|json|md|mjs|sh|txt|vert)$|/$' | sort -u)
done

# docs/design/step.md has a line for every kernel; a kernel that exists for each kind of constraint has a line for each kind
steps=$(<docs/design/step.md)
while read -r kernel; do
	[[ $steps = *"\`$kernel\`"* ]] || complain "docs/design/step.md: kernel $kernel is missing"
done < <(sed -nE 's/^CONSTRAINT_KIND\(([a-z]+),.*/\1/p' src/pools/kinds.def | while read -r kind; do
	sed -nE -e '/^\/\//d' -e "s/kind##/$kind/" -e 's/^.*X\(([a-z_0-9]*),.*/\1/p' src/stages/kernels.def
done | sort -u)

# docs/design/dialect.md has a line for every word of the dialect, except words that only other words use
words=$(<docs/design/dialect.md)
while read -r word; do
	[[ $words = *"\`$word"[\`\(]* ]] || complain "docs/design/dialect.md: the word $word is missing"
done < <(sed -nE -e 's/^#define ([A-Za-z_0-9]+).*/\1/p' -e 's/^INLINE [A-Za-z0-9]+\*? ([a-z_0-9]+)\(.*/\1/p' \
	-e 's/^typedef .*[ }]([A-Z][A-Za-z0-9]*)( __attribute__.*)?;.*/\1/p' src/dialect/{dialect,opencl_words,c_words,wide}.h |
	grep -vxE '(DIALECT|OPENCL_WORDS|C_WORDS|WIDE)_H|ROW|KERNEL_JOIN_?' | sort -u)

# Comments are plain English (STYLE.md). The check finds bad first words and some bad phrases.
sources=(-name '*.c' -o -name '*.h' -o -name '*.cl' -o -name '*.cpp' -o -name '*.def' -o -name '*.js' -o -name '*.mjs'
	-o -name '*.vert' -o -name '*.frag' -o -name '*.glsl')
scripts=(-name '*.sh' -o -name '*.awk' -o -name '*.cmake' -o -name CMakeLists.txt)
folders=(bench cli examples include mpi scene src tests tools validate view web)
while read -r line; do
	complain "$line"
done < <(find "${folders[@]}" \( "${sources[@]}" \) -print0 | sort -z | xargs -0 awk -f tests/comments.awk)

# Paths in comments exist. A path with a folder is relative to the root, to src/, to include/ or to the folder of the
# file that contains the comment. A name without a folder may be the name of any file. Names with capitals, such as
# NAME.c, are placeholders.
others=' shared/human.c shared/benchmarks.c ' # files of Box2D
files=$(find . -path ./build -prune -o -type f -printf '/%f\n' | sort -u)
while read -r place path; do
	folder=${place%:*}
	folder=${folder%/*}
	if [[ $path != */* ]]; then
		[[ $files$'\n' = */"$path"$'\n'* ]] || complain "$place: the comment names $path, which does not exist"
	elif [[ $others != *" $path "* ]]; then
		exists "$path" "$folder" || [ -e "include/$path" ] || complain "$place: the comment names $path, which does not exist"
	fi
done < <(find cmake "${folders[@]}" \( "${sources[@]}" -o "${scripts[@]}" \) -print0 | sort -z | xargs -0 awk '
	FNR == 1 { script = FILENAME ~ /\.(sh|awk|cmake|txt)$/ }
	script { if ($0 !~ /^[ \t]*#/) next; text = $0 }
	!script { if (!match($0, /(^|[ \t;,{})])\/\/ /)) next; text = substr($0, RSTART) }
	{
		while (match(text, /[A-Za-z0-9_.\/-]*[A-Za-z0-9_]\.(c|h|cl|cpp|def|md|sh|json|mjs|js|cmake|vert|frag|glsl|awk)($|[^A-Za-z0-9_])/))
		{
			path = substr(text, RSTART, RLENGTH)
			text = substr(text, RSTART + RLENGTH)
			sub(/[^A-Za-z0-9_]$/, "", path)
			if (path ~ /^[^A-Z]+$/ && (path ~ /\// || (!script && path ~ /\.(c|h|cl|def)$/ && FILENAME !~ /js$/)))
				print FILENAME ":" FNR " " path
		}
	}')

# files of the stages, the constraints and the pools do not distinguish compilers
found=$(grep -rlE "__OPENCL|__GNUC__|__clang__" src/stages src/constraints src/pools | tr '\n' ' ' || true)
[ -z "$found" ] || complain "only src/dialect/dialect.h may distinguish compilers, not $found"

# every file begins with its licence and a sentence about its content
while read -r file; do
	complain "$file: does not begin with its licence and a line \"// NAME -- CONTENT\""
done < <(find include src cli scene tools validate view tests examples \( -name '*.c' -o -name '*.h' \) -print0 | xargs -0 awk '
	FNR == 1 { if (last && !good) print last; last = FILENAME; first = $0; good = 0 }
	FNR == 2 { name = FILENAME; sub(".*/", "", name); good = first $0 ~ "^// SPDX-License-Identifier: MIT// " name " -- " }
	END { if (last && !good) print last }')
exit $failed
