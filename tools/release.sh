#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# release.sh -- makes the files of a release in build/release: sources, page, npm package, SHA256SUMS.
#
# usage: tools/release.sh
# The version is that of include/scree/scree.h. The script refuses a tree with uncommitted changes, a version without a section in
# CHANGELOG.md, and a version whose tag is on another commit. Page and package are built from the unpacked sources, so they contain
# nothing of an older build. Prints the command that sets the tag, but does not set it.
set -euo pipefail
. "$(dirname "$0")/usage.sh"
cd "$(dirname "$0")/.."
refuse()
{
	echo "release.sh: $*" >&2
	exit 1
}

version=$(sed -n 's/^#define SCREE_VERSION_[A-Z]* //p' include/scree/scree.h | paste -sd .)
commit=$(git rev-parse HEAD)
changes=$(git status --porcelain)
[ -z "$changes" ] || refuse "the tree has changes that are not committed:"$'\n'"$changes"
section=$(grep -E "^## ${version//./\\.}( |\$)" CHANGELOG.md) || refuse "CHANGELOG.md has no section \"## $version\""
tagged=$(git rev-parse --quiet --verify "refs/tags/v$version^{commit}" || true)
[ -z "$tagged" ] || [ "$tagged" = "$commit" ] || refuse "the tag v$version is on $tagged, and this is $commit"

folder=build/release name=scree-$version
tree=$folder/$name
rm -rf "$folder"
mkdir -p "$folder"
git archive --prefix="$name/" "$commit" | gzip -9n >"$folder/$name.tar.gz"
tar -xzf "$folder/$name.tar.gz" -C "$folder"
# the native build is only needed for thumbnails
make -C "$tree" web build_options="-DSCREE_BUILD_TESTS=OFF -DSCREE_BUILD_PEERS=OFF"
# the page contains code of Scree and of Jansson
cp LICENSE "$tree/build/web/LICENSE"
cp "$tree/build/sources/jansson/LICENSE" "$tree/build/web/LICENSE.jansson"

# pack FOLDER PREFIX FILE: packs a folder; order, owner, time and mode of the packed files are the same on every machine
pack()
{
	tar --sort=name --format=ustar --mtime="@$(git log -1 --format=%ct "$commit")" --owner=0 --group=0 --numeric-owner \
		--mode=u=rwX,go=rX --exclude=./package --transform="s,^\.,$2," -C "$1" -cf - . | gzip -9n >"$folder/$3"
}
pack "$tree/build/web" "scree-page-$version" "scree-page-$version.tar.gz"
# npm requires that all paths in the archive begin with "package/"
pack "$tree/build/web/package" package "scree-npm-$version.tgz"
rm -rf "$tree"
(cd "$folder" && sha256sum -- *.t*gz >SHA256SUMS && cat SHA256SUMS)

echo "The files of Scree $version are in $folder."
[[ $section != *unreleased* ]] || echo "CHANGELOG.md says \"$section\": give it the date, commit, and run make release again before the tag."
placeholder=https://example.org/scree
# this script and CONTRIBUTING.md keep the placeholder, because they explain it
files=$(git grep -lF "$placeholder" -- . ':!tools/release.sh' ':!CONTRIBUTING.md' | paste -sd ' ' || true)
[ -z "$files" ] || echo "$files: $placeholder is a placeholder for the address of the project (CONTRIBUTING.md)."
echo "The tag: git tag -a v$version -m 'Scree $version' $commit && git push origin v$version"
