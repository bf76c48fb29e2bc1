// SPDX-License-Identifier: MIT
// transpose.h -- loads and stores LANES items of 4 or 8 floats, as one Real per component; a part of wide.h.
//
// Four Reals are loaded with quads (four floats) side by side: Real j gets the quads of items j, j + 4, j + 8, ... Then
// 4 by 4 transpositions put component j of all items into Real j. A gather of eight floats on AVX2 takes 8 loads, 8
// inserts and 16 shuffles; with whole rows it would take 24 shuffles, and the shuffle port is the bottleneck.
#ifndef TRANSPOSE_H
#define TRANSPOSE_H
#define ALL_LANES ((1u << LANES) - 1)

// Always inlined, because every solver pass uses these functions, and a call would pass vectors through memory.
#define WIDE_INLINE static inline __attribute__((always_inline))

typedef float Quad __attribute__((vector_size(16)));
typedef Word Words __attribute__((vector_size(4 * LANES)));

WIDE_INLINE Quad quad_load(const float* from) { return *(const Quad*)from; }
WIDE_INLINE void quad_store(float* to, Quad q) { *(Quad*)to = q; }

#define FOUR_LANES(f, k) f(k), f(k + 1), f(k + 2), f(k + 3)
// Indices k, k + 2, ... of every second number of two quads; EVERY_SECOND: the same for all lanes of two vectors.
#define TWO_QUADS(k) k, k + 2, k + 4, k + 6
#if LANES == 4
#define EACH_QUAD(a, b, c, d) a, b, c, d
#define EVERY_SECOND(k)       TWO_QUADS(k)
#define EACH_LANE(f)          FOUR_LANES(f, 0)
#define EACH_HALF(f)          f(0), f(1)
#elif LANES == 8
#define EACH_QUAD(a, b, c, d) a, b, c, d, a + 4, b + 4, c + 4, d + 4
#define EVERY_SECOND(k)       TWO_QUADS(k), TWO_QUADS(k + 8)
#define EACH_LANE(f)          FOUR_LANES(f, 0), FOUR_LANES(f, 4)
#define EACH_HALF(f)          FOUR_LANES(f, 0)
#else
#define EACH_QUAD(a, b, c, d) \
	a, b, c, d, a + 4, b + 4, c + 4, d + 4, a + 8, b + 8, c + 8, d + 8, a + 12, b + 12, c + 12, d + 12
#define EVERY_SECOND(k) TWO_QUADS(k), TWO_QUADS(k + 8), TWO_QUADS(k + 16), TWO_QUADS(k + 24)
#define EACH_LANE(f)    FOUR_LANES(f, 0), FOUR_LANES(f, 4), FOUR_LANES(f, 8), FOUR_LANES(f, 12)
#define EACH_HALF(f)    FOUR_LANES(f, 0), FOUR_LANES(f, 4)
#endif

WIDE_INLINE Int indices(int i)
{
	Int k = {EACH_QUAD(0, 1, 2, 3)};
	return k + i;
}

// Element of `array` for lane k. Compilers turn a list of all lanes into inserts, but a loop over lanes into masks.
#define NAMED(k) array[index[k]]
WIDE_INLINE Real gather(const float* array, Int index) { return (Real){EACH_LANE(NAMED)}; }
WIDE_INLINE Int gather_int(const int* array, Int index) { return (Int){EACH_LANE(NAMED)}; }
#undef NAMED

// Shuffles inside each quad: indices 0 to 3 are components of a, LANES to LANES + 3 are components of b.
#if defined(__clang__) || __GNUC__ >= 12
#define SHUFFLE_ALL(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define SHUFFLE_ALL(a, b, ...) __builtin_shuffle(a, b, (Int){__VA_ARGS__})
#endif
#define SHUFFLE(a, b, ...) SHUFFLE_ALL(a, b, EACH_QUAD(__VA_ARGS__))

// following(a, b): lane k is lane k + 1 of a; the last lane is lane 0 of b. preceding(a, b): lane k is lane k - 1 of b;
// lane 0 is the last lane of a.
#define NEXT(k) k + 1
#define LAST(k) k + LANES - 1
WIDE_INLINE Real following(Real a, Real b) { return SHUFFLE_ALL(a, b, EACH_LANE(NEXT)); }
WIDE_INLINE Real preceding(Real a, Real b) { return SHUFFLE_ALL(a, b, EACH_LANE(LAST)); }
WIDE_INLINE Int following_int(Int a, Int b) { return SHUFFLE_ALL(a, b, EACH_LANE(NEXT)); }
WIDE_INLINE Int preceding_int(Int a, Int b) { return SHUFFLE_ALL(a, b, EACH_LANE(LAST)); }
#undef NEXT
#undef LAST

WIDE_INLINE void load_int2(const Int2* array, int i, Int* x, Int* y)
{
	Int low, high;
	memcpy(&low, array + i, sizeof low);
	memcpy(&high, array + i + LANES / 2, sizeof high);
	*x = SHUFFLE_ALL(low, high, EVERY_SECOND(0));
	*y = SHUFFLE_ALL(low, high, EVERY_SECOND(1));
}

#define BOTH_LOW(k)  k, k + LANES
#define BOTH_HIGH(k) k + LANES / 2, k + LANES / 2 + LANES
WIDE_INLINE void store_int2(Int2* array, int i, Int x, Int y)
{
	Int low = SHUFFLE_ALL(x, y, EACH_HALF(BOTH_LOW)), high = SHUFFLE_ALL(x, y, EACH_HALF(BOTH_HIGH));
	memcpy(array + i, &low, sizeof low);
	memcpy(array + i + LANES / 2, &high, sizeof high);
}
#undef BOTH_LOW
#undef BOTH_HIGH

// Gathers pairs of floats, aligned to 8 bytes: *x and *y, lane k, are those of pair index[k].
typedef Word64 Pairs __attribute__((vector_size(4 * LANES)));
WIDE_INLINE Word64 pair_at(const float* base, int index)
{
	Word64 pair;
	memcpy(&pair, base + 2 * (size_t)index, sizeof pair);
	return pair;
}
#define LOW(k)  pair_at(base, index[k])
#define HIGH(k) pair_at(base, index[k + LANES / 2])
WIDE_INLINE void gather_pairs(const float* base, Int index, Real* x, Real* y)
{
	Real low = (Real)(Pairs){EACH_HALF(LOW)}, high = (Real)(Pairs){EACH_HALF(HIGH)};
	*x = SHUFFLE_ALL(low, high, EVERY_SECOND(0));
	*y = SHUFFLE_ALL(low, high, EVERY_SECOND(1));
}
#undef LOW
#undef HIGH

// Loads the quads at base + at[j], base + at[j + 4], ... side by side.
WIDE_INLINE Real quads_load(const float* base, Words at, int j)
{
	Quad first = quad_load(base + at[j]);
#if LANES == 4
	return first;
#elif LANES == 8 && defined(__AVX__)
	return _mm256_insertf128_ps(_mm256_castps128_ps256(first), quad_load(base + at[j + 4]), 1);
#elif LANES == 16 && defined(__AVX512F__)
	Real r = _mm512_castps128_ps512(first);
	r = _mm512_insertf32x4(r, quad_load(base + at[j + 4]), 1);
	r = _mm512_insertf32x4(r, quad_load(base + at[j + 8]), 2);
	return _mm512_insertf32x4(r, quad_load(base + at[j + 12]), 3);
#else
	Real r;
	memcpy(&r, &first, 16);
	for (int k = 1; k < LANES / 4; ++k)
		memcpy((char*)&r + 16 * k, base + at[j + 4 * k], 16);
	return r;
#endif
}

WIDE_INLINE Quad quads_get(Real r, int k)
{
#if LANES == 4
	(void)k;
	return r;
#elif LANES == 8 && defined(__AVX__)
	return k == 0 ? _mm256_castps256_ps128(r) : _mm256_extractf128_ps(r, 1);
#elif LANES == 16 && defined(__AVX512F__)
	switch (k)
	{
	case 0:
		return _mm512_castps512_ps128(r);
	case 1:
		return _mm512_extractf32x4_ps(r, 1);
	case 2:
		return _mm512_extractf32x4_ps(r, 2);
	default:
		return _mm512_extractf32x4_ps(r, 3);
	}
#else
	Quad q;
	memcpy(&q, (const char*)&r + 16 * k, 16);
	return q;
#endif
}

// Transposes each 4 by 4 block of the matrix with rows a, b, c, d into out.
WIDE_INLINE void transpose(Real a, Real b, Real c, Real d, Real out[4])
{
	Real ab01 = SHUFFLE(a, b, 0, LANES, 1, LANES + 1);
	Real cd01 = SHUFFLE(c, d, 0, LANES, 1, LANES + 1);
	Real ab23 = SHUFFLE(a, b, 2, LANES + 2, 3, LANES + 3);
	Real cd23 = SHUFFLE(c, d, 2, LANES + 2, 3, LANES + 3);
	out[0] = SHUFFLE(ab01, cd01, 0, 1, LANES, LANES + 1);
	out[1] = SHUFFLE(ab01, cd01, 2, 3, LANES + 2, LANES + 3);
	out[2] = SHUFFLE(ab23, cd23, 0, 1, LANES, LANES + 1);
	out[3] = SHUFFLE(ab23, cd23, 2, 3, LANES + 2, LANES + 3);
}

// Gathers four floats per lane: out[j], lane k, is float j of the four at base + at[k].
WIDE_INLINE void quads_gather(const float* base, Words at, Real out[4])
{
	transpose(quads_load(base, at, 0), quads_load(base, at, 1), quads_load(base, at, 2), quads_load(base, at, 3), out);
}

// Stores the quads of r at base + at[k] for k = j, j + 4, j + 8, ...; each only if bit k of `wanted` is set.
WIDE_INLINE void quads_store(float* base, Words at, int j, Real r, Word wanted)
{
	if (wanted >> j & 1)
		quad_store(base + at[j], quads_get(r, 0));
#if LANES >= 8
	if (wanted >> (j + 4) & 1)
		quad_store(base + at[j + 4], quads_get(r, 1));
#endif
#if LANES >= 16
	if (wanted >> (j + 8) & 1)
		quad_store(base + at[j + 8], quads_get(r, 2));
	if (wanted >> (j + 12) & 1)
		quad_store(base + at[j + 12], quads_get(r, 3));
#endif
}

WIDE_INLINE void quads_scatter(float* base, Words at, const Real in[4], Word wanted)
{
	Real r[4];
	transpose(in[0], in[1], in[2], in[3], r);
	quads_store(base, at, 0, r[0], wanted);
	quads_store(base, at, 1, r[1], wanted);
	quads_store(base, at, 2, r[2], wanted);
	quads_store(base, at, 3, r[3], wanted);
}

// Returns the offsets, in floats, of LANES consecutive rows of `floats` floats.
WIDE_INLINE Words neighbors(Word floats)
{
	Words k = {EACH_QUAD(0, 1, 2, 3)};
	return k * floats;
}

// Gathers items of eight floats, aligned to 32 bytes: out[j], lane k, is float j of item index[k].
WIDE_INLINE void gather_rows8(const float* base, Int index, Real out[8])
{
	Words at = (Words)index * 8u;
	quads_gather(base, at, out);
	quads_gather(base + 4, at, out + 4);
}

WIDE_INLINE void load_rows8(const float* base, int first, Real out[8])
{
	const float* rows = base + 8 * (size_t)first;
	quads_gather(rows, neighbors(8), out);
	quads_gather(rows + 4, neighbors(8), out + 4);
}

WIDE_INLINE void store_rows8(float* base, int first, const Real in[8])
{
	float* rows = base + 8 * (size_t)first;
	quads_scatter(rows, neighbors(8), in, ALL_LANES);
	quads_scatter(rows + 4, neighbors(8), in + 4, ALL_LANES);
}

// Gathers items of four floats, aligned to 16 bytes: out[j], lane k, is float j of item index[k].
WIDE_INLINE void gather_rows4(const float* base, Int index, Real out[4]) { quads_gather(base, (Words)index * 4u, out); }

WIDE_INLINE void load_rows4(const float* base, int first, Real out[4])
{
	quads_gather(base + 4 * (size_t)first, neighbors(4), out);
}

WIDE_INLINE void store_rows4(float* base, int first, const Real in[4])
{
	quads_scatter(base + 4 * (size_t)first, neighbors(4), in, ALL_LANES);
}

WIDE_INLINE Word lane_bits(Int lanes)
{
#if LANES == 16 && defined(__AVX512F__)
	return _mm512_test_epi32_mask((__m512i)lanes, (__m512i)lanes);
#elif LANES == 8 && defined(__AVX__)
	return (Word)_mm256_movemask_ps((Real)(lanes != 0));
#elif LANES == 4 && defined(__SSE2__)
	return (Word)_mm_movemask_ps((Real)(lanes != 0));
#elif LANES == 4 && defined(__wasm_simd128__)
	return wasm_i32x4_bitmask((v128_t)(lanes != 0));
#else
	Word bits = 0;
	for (int k = 0; k < LANES; ++k)
		bits |= (Word)(lanes[k] != 0) << k;
	return bits;
#endif
}

WIDE_INLINE Real root(Real x)
{
#if LANES == 4 && defined(__wasm_simd128__)
	return (Real)wasm_f32x4_sqrt((v128_t)x); // clang would compile the loop below to accesses of memory
#else
	for (int k = 0; k < LANES; ++k)
		x[k] = __builtin_sqrtf(x[k]);
	return x;
#endif
}

// Writes four floats at base + at[k] for lanes k with `wanted` set; these places must differ.
WIDE_INLINE void quads_scatter_some(float* base, Words at, const Real in[4], Int wanted)
{
	Word bits = lane_bits(wanted);
	if (bits == ALL_LANES)
		quads_scatter(base, at, in, ALL_LANES); // omits the tests of lanes
	else
		quads_scatter(base, at, in, bits);
}

// Writes the first four of the eight floats of item index[k] for lanes k with `wanted` set.
WIDE_INLINE void scatter_rows4of8(float* base, Int index, const Real in[4], Int wanted)
{
	quads_scatter_some(base, (Words)index * 8u, in, wanted);
}

// Writes the four floats of item index[k] for lanes k with `wanted` set.
WIDE_INLINE void scatter_rows4(float* base, Int index, const Real in[4], Int wanted)
{
	quads_scatter_some(base, (Words)index * 4u, in, wanted);
}

#undef ALL_LANES
#undef EACH_QUAD
#undef SHUFFLE
#undef SHUFFLE_ALL
#undef TWO_QUADS
#undef EVERY_SECOND
#undef FOUR_LANES
#undef EACH_LANE
#undef EACH_HALF
#undef WIDE_INLINE
#endif
