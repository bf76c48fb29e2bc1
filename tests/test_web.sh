#!/usr/bin/env bash
# test_web.sh -- checks the builds for WebAssembly: the golden hash of every scene; interface, types, debug draw, example and
# size of the npm package, whose example also runs in Chromium.
set -euo pipefail
build=$SCREE_SOURCE/build
for form in scalar simd threads; do
	if [ ! -f "$build/wasm-$form/golden.wasm" ]; then
		echo "build/wasm-$form has no golden.wasm: make web builds it"
		case " $SCREE_EXPECT " in *" web "*) exit 1 ;; *) exit 77 ;; esac
	fi
done
scratch=$SCREE_BUILD/web-test
rm -rf "$scratch"
mkdir -p "$scratch/node_modules"
trap 'rm -rf "$scratch"' EXIT

# with the fetch of node, the loader of Emscripten would assume that it runs in a browser
golden() { timeout 300 node --no-experimental-fetch "$build/wasm-$1/golden.js" "$2" "$3" "$4" >"$scratch/hashes"; }
lines=$(($(grep -vc '^#' "$SCREE_SOURCE/tests/golden.txt") / 2))
for run in "scalar 1 1 1" "simd 4 1 1" "threads 4 1 4" "threads 4 2 4"; do
	# word splitting of $run is intended
	golden $run
	[ "$(wc -l <"$scratch/hashes")" = "$lines" ] || { echo "$run: $(wc -l <"$scratch/hashes") scenes, golden.txt has $lines"; exit 1; }
	if wrong=$(grep -vxFf "$SCREE_SOURCE/tests/golden.txt" "$scratch/hashes"); then
		echo "WebAssembly ($run) has other hashes than tests/golden.txt:" "$wrong"
		exit 1
	fi
	echo "$run: $lines hashes are golden"
done

package=$scratch/node_modules/scree
node "$SCREE_SOURCE/web/package/pack.mjs" "$SCREE_SOURCE" "$build/wasm-scalar" "$build/wasm-simd" "$package"
cp "$SCREE_SOURCE/tests/web/api.mjs" "$SCREE_SOURCE/examples/hello.mjs" "$scratch"
for form in scalar simd; do
	timeout 300 node --expose-gc "$scratch/api.mjs" $form
done
${CC:-cc} -std=c17 -I"$SCREE_SOURCE/include" "$SCREE_SOURCE/examples/hello.c" "$SCREE_BUILD/libscree.a" -lm -ldl -pthread -o "$scratch/hello"
# batches: both engines repeat examples/train.c
cp "$SCREE_SOURCE/tests/web/batch.mjs" "$scratch"
for form in scalar simd; do
	[ "$(timeout 300 node "$scratch/batch.mjs" $form 2>"$scratch/batch.txt")" = "$("$SCREE_BUILD/train" | tail -n 1)" ] ||
		{ echo "scree/batch ($form) differs from train.c, or fails:"; cat "$scratch/batch.txt"; exit 1; }
done
echo "scree/batch: both engines learn as train.c"
# snapshots that the native library writes: on the CPU with the most lanes, and through OpenCL
cp "$SCREE_SOURCE/tests/web/snapshots.mjs" "$scratch"
snapshots()
{
	local folder=$scratch/snapshots-$1
	mkdir "$folder"
	timeout 300 "$SCREE_BUILD/tests/snapshot_scenes" "$1" 60 small "$folder" "${@:2}" >"$folder/list.txt"
	for form in scalar simd; do
		timeout 300 node "$scratch/snapshots.mjs" $form "$folder"
	done
}
snapshots cpu
# debug draw: both builds draw the same as the native library
cp "$SCREE_SOURCE/tests/web/drawn.mjs" "$scratch"
${CC:-cc} -std=c17 -Wall -Wextra -I"$SCREE_SOURCE/include" "$SCREE_SOURCE/tests/web/drawn.c" "$SCREE_BUILD/libscree.a" -lm -ldl -pthread -o "$scratch/drawn"
drawn=0
for snapshot in "$scratch"/snapshots-cpu/*.snap; do
	"$scratch/drawn" "$snapshot" | LC_ALL=C sort -s -k1,1 >"$scratch/native.txt"
	for form in scalar simd; do
		timeout 300 node "$scratch/drawn.mjs" $form "$snapshot" | LC_ALL=C sort -s -k1,1 >"$scratch/drawn.txt"
		cmp "$scratch/native.txt" "$scratch/drawn.txt" || { echo "scree/draw ($form) differs from scree_world_draw: $snapshot"; exit 1; }
	done
	drawn=$((drawn + $(wc -l <"$scratch/native.txt")))
done
echo "scree/draw: $drawn calls are those of scree_world_draw"
# recordings: those of both builds are the same, and the native command line repeats them
cp "$SCREE_SOURCE/tests/web/recordings.mjs" "$scratch"
for form in scalar simd; do
	timeout 300 node "$scratch/recordings.mjs" $form "$SCREE_SOURCE" "$scratch"
	"$SCREE_BUILD/scree" replay "$scratch/$form.rec" --device cpu | grep 'all equal' || { echo "a recording of the package ($form) differs"; exit 1; }
done
cmp "$scratch/scalar.rec" "$scratch/simd.rec"
if "$SCREE_BUILD/scree" devices | grep -q opencl; then
	snapshots opencl storm ragdolls platformer churn
fi
[ "$(wc -l <"$SCREE_SOURCE/examples/hello.mjs")" -le 30 ]
[ "cpu: $(node "$scratch/hello.mjs")" = "$("$scratch/hello")" ] || { echo "hello.mjs and hello.c differ:" "$(node "$scratch/hello.mjs")" "$("$scratch/hello")"; exit 1; }
if command -v tsc >/dev/null; then
	cp "$SCREE_SOURCE/tests/web/types.mts" "$scratch"
	(cd "$scratch" && timeout 300 tsc --strict --noEmit --target es2022 --module nodenext --moduleResolution nodenext --lib es2022,dom types.mts)
else
	echo "the types were not checked: there is no tsc; Debian has it in node-typescript"
	case " $SCREE_EXPECT " in *" web "*) exit 1 ;; esac
fi
if command -v chromedriver >/dev/null && command -v chromium >/dev/null; then
	line=$(timeout 300 node "$SCREE_SOURCE/tests/web/browser.mjs" "$scratch")
	[ "cpu: $line" = "$("$scratch/hello")" ] || { echo "hello.mjs in Chromium and hello.c differ: $line"; exit 1; }
else
	echo "the package was not run in a browser: there is no chromium or no chromedriver; Debian has them in chromium and chromium-driver"
	case " $SCREE_EXPECT " in *" web "*) exit 1 ;; esac
fi
for file in $(node -p 'JSON.parse(fs.readFileSync(process.argv[1])).files.join(" ")' "$package/package.json"); do
	[ -s "$package/$file" ] || { echo "package.json names $file, which is not there"; exit 1; }
done
