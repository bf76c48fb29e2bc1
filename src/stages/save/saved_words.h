// SPDX-License-Identifier: MIT
// saved_words.h -- packs items into a save: words of fixed number, and the rest, words that differ from a prediction.
//
// An item has a row of words in the pool `saved`. Word k of all items of a part are adjacent, so that the work-items of
// a GPU write adjacent words. Most other values of an item follow from the row, from other items, or are almost always
// the same. Each is compared with a prediction, and those that differ are appended to the rest of the save, so that no
// value is lost whatever it is. The rest of an item begins with a mask of its values. A flag of the row marks an item with
// a rest; then a word of the row is the place of the rest, and the value of this word follows the mask. Only the order of
// the rest depends on timing.
#ifndef SAVED_WORDS_H
#define SAVED_WORDS_H
#include "dialect/dialect.h"
#include "pools/pools.h"

INLINE GLOBAL Word* saved_words(const Pools* p) { return (GLOBAL Word*)(p->saved + p->step.saved.first); }

// Returns the first word of the row of item i of a part, and the distance of the words of a row.
#define saved_row(p, part, i) (saved_words(p) + (p)->step.saved.part.at + (i))
#define saved_by(p, part)     ((size_t)(p)->step.saved.part.count)

// Reserves words of the rest for item i. Returns the place of the first one, or -1 if there is no room; the host then
// repeats the save with more room. Each zone of the rest has a counter in the head, because a GPU adds to one counter only
// once in a nanosecond. The upper bits of a product select the zone, so that items at equal distances have different ones.
INLINE int saved_reserve(const Pools* p, int i, int count)
{
	int zone = (int)((Word)i * 0x9e3779b9u >> 16) & (p->step.saved.zones - 1), room = p->step.saved.room;
	int place = atomic_add_int((GLOBAL int*)saved_words(p) + zone, count);
	return place > room - count ? -1 : zone * room + place;
}

// Reserves words of the rest of item i for a value of a row and `mask`, of the values that differ. Returns the place of the
// words for these values, or null if there is no room.
OUT_OF_LINE GLOBAL Word* saved_rest(const Pools* p, int i, Word mask, Word value, GLOBAL Word* instead)
{
	int count = 2;
	for (Word left = mask; left != 0; left &= left - 1)
		++count;
	int place = saved_reserve(p, i, count);
	if (place < 0)
		return 0;
	GLOBAL Word* rest = saved_words(p) + p->step.saved.rest + place;
	rest[0] = mask;
	rest[1] = value;
	*instead = (Word)place;
	return rest + 2;
}

INLINE const GLOBAL Word* saved_rest_at(const Pools* p, Word place)
{
	return saved_words(p) + p->step.saved.rest + place;
}

// Returns the words of a row's values that differ, and sets *mask to these values; 0 if the row is not `rested`. word: word of
// the row that is the place of the rest if there is one; becomes its value.
OUT_OF_LINE const GLOBAL Word* saved_open(const Pools* p, int rested, Word* word, Word* mask)
{
	*mask = 0;
	if (!rested)
		return saved_words(p);
	const GLOBAL Word* rest = saved_rest_at(p, *word);
	*mask = rest[0];
	*word = rest[1];
	return rest + 2;
}

// Words of a place of contacts: the slot of the contact and flags of the place; the impulses, of which the first word is
// the place of the rest, if there is one; flags and pose of the contact. Padding has no rest, and its second word is its
// second body.
#define SAVED_IMPULSES 1
#define SAVED_FLAGS    5
#define SAVED_POSE     6 // pose of shape b in the frame of shape a, rotation of shape a

// Writes the lanes where `wanted` is set.
INLINE void saved_put(GLOBAL int* array, int i, Int x, Int wanted)
{
	store_int(array, i, blend_int(load_int(array, i), x, wanted));
}

// The macros below process an entry (value, prediction) of a list of values: an int, or a number. Callers have declared
// `mask`, `bit` and `rest`, and `bit` is 0 before a list.
#define SAVED_DIFFERS_INT(value, expected)    mask |= (Word)((value) != (expected)) << bit++;
#define SAVED_DIFFERS_NUMBER(value, expected) mask |= (Word)(float_word(value) != float_word(expected)) << bit++;
#define SAVED_PUT_INT(value, expected) \
	if (mask >> bit++ & 1u)            \
		*rest++ = (Word)(value);
#define SAVED_PUT_NUMBER(value, expected) \
	if (mask >> bit++ & 1u)               \
		*rest++ = float_word(value);
#define SAVED_TAKE_INT(value, expected)    (value) = mask >> bit++ & 1u ? (int)*rest++ : (expected);
#define SAVED_TAKE_NUMBER(value, expected) (value) = mask >> bit++ & 1u ? bits_float((int)*rest++) : (expected);

#endif
