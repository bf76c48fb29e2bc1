#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_scripts.sh -- checks that the scripts of bench/ and tools/ print their use and refuse unknown options; checks releases
# without a build.
set -uo pipefail
source=${SCREE_SOURCE:?is the folder of the sources}
scratch=$(mktemp -d "${SCREE_BUILD:?}/test_scripts.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
failures=0
fail()
{
	echo "FAILED: $*"
	sed 's/^/    | /' out err
	failures=$((failures + 1))
}

# expect CODE TEXT command...: checks that the command ends with this exit code, and that its output contains the text
expect()
{
	local code=$1 text=$2 got
	shift 2
	timeout 60 "$@" >out 2>err </dev/null
	got=$?
	[ "$got" = "$code" ] || fail "$*: exit code $got instead of $code"
	grep -qF -- "$text" out err || fail "$*: does not say \"$text\""
}

# checks --help and unknown options, first and after another argument
options()
{
	local name=${*: -1}
	name=${name##*/}
	for option in -h --help; do
		expect 0 "$name -- " "$@" $option
		[ -s err ] && fail "$* $option: prints on standard error"
	done
	expect 0 "$name -- " "$@" argument --help
	expect 2 "$name: unknown option --frobnicate" "$@" --frobnicate
	expect 2 "$name: unknown option -x" "$@" argument -x
}
while read -r script; do
	options "$script"
done < <(find "$source/bench" "$source/tools" -name '*.sh' -perm -u+x)
if command -v node >/dev/null; then
	while read -r program; do
		options node "$program"
	done < <(grep -lE 'process\.argv' "$source"/bench/web/*.mjs | grep -v '/usage\.mjs$')
fi

# makes releases of a small tree, in which "make web" only creates small files with the right names
command -v git >/dev/null || { echo "skipped: there is no git"; exit 77; }
export GIT_CONFIG_GLOBAL=/dev/null GIT_AUTHOR_NAME=test GIT_COMMITTER_NAME=test GIT_AUTHOR_EMAIL=test GIT_COMMITTER_EMAIL=test
mkdir -p tree/tools tree/include/scree
cp "$source/tools/release.sh" "$source/tools/usage.sh" tree/tools
cp "$source/LICENSE" tree
printf '#define SCREE_VERSION_%s\n' 'MAJOR 7' 'MINOR 8' 'PATCH 9' >tree/include/scree/scree.h
printf '# Changelog\n\n## 7x8.9\n' >tree/CHANGELOG.md
printf '/build\n' >tree/.gitignore
printf 'web:\n' >tree/Makefile
printf '\t@%s\n' 'mkdir -p build/web/package build/sources/jansson' 'echo page >build/web/index.html' \
	'echo {} >build/web/package/package.json' 'echo licence >build/sources/jansson/LICENSE' >>tree/Makefile
commit() { git -C tree add -A && git -C tree commit -q -m "$1"; }
git -C tree init -q 2>out && commit first || fail "git: no repository"
expect 2 'release.sh: unexpected argument 0.2.0' tree/tools/release.sh 0.2.0
expect 1 'CHANGELOG.md has no section "## 7.8.9"' tree/tools/release.sh
printf '## 7.8.9 (unreleased)\n' >>tree/CHANGELOG.md
expect 1 ' M CHANGELOG.md' tree/tools/release.sh
[ -e tree/build ] && fail "release.sh: writes files in spite of the error"
commit second
expect 0 "git tag -a v7.8.9 -m 'Scree 7.8.9' $(git -C tree rev-parse HEAD)" tree/tools/release.sh
grep -q 'give it the date' out || fail "release.sh: does not say that the version has no date"
placeholder=$(sed -n 's/^placeholder=//p' tree/tools/release.sh)
grep -q "${placeholder:?}" out && fail "release.sh: names a placeholder that no file has"
release=tree/build/release
[ "$(ls $release)" = "$(printf '%s\n' SHA256SUMS scree-7.8.9.tar.gz scree-npm-7.8.9.tgz scree-page-7.8.9.tar.gz)" ] ||
	fail "release.sh: has other files:" "$(ls $release)"
(cd $release && sha256sum --quiet -c SHA256SUMS) || fail "SHA256SUMS is wrong"
for file in scree-7.8.9.tar.gz:scree-7.8.9/LICENSE scree-npm-7.8.9.tgz:package/package.json scree-page-7.8.9.tar.gz:scree-page-7.8.9/index.html \
	scree-page-7.8.9.tar.gz:scree-page-7.8.9/LICENSE scree-page-7.8.9.tar.gz:scree-page-7.8.9/LICENSE.jansson; do
	tar -tzf "$release/${file%:*}" >out
	grep -qx "${file#*:}" out || fail "${file%:*}: has no ${file#*:}"
done
grep -q package out && fail "the page has the package in it"
mkdir tree/docs
echo "git clone $placeholder" >tree/docs/start.md
sed -i 's/ (unreleased)/ (2000-01-01)/' tree/CHANGELOG.md
commit third
git -C tree tag v7.8.9 HEAD^
expect 1 'the tag v7.8.9 is on' tree/tools/release.sh
git -C tree tag -f v7.8.9 >out
expect 0 'Scree 7.8.9' tree/tools/release.sh
grep -q 'give it the date' out && fail "release.sh: misses a date that is there"
grep -q "^docs/start.md: $placeholder" out || fail "release.sh: does not name a file that has the placeholder"
cp $release/SHA256SUMS first
sleep 1
expect 0 'Scree 7.8.9' tree/tools/release.sh
cmp -s first $release/SHA256SUMS || fail "release.sh: the same commit has other bytes"
[ $failures = 0 ]
