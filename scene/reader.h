// SPDX-License-Identifier: MIT
// reader.h -- reading JSON values with checks whose errors name the place in the file.
#ifndef READER_H
#define READER_H
#include "scene/expression.h"
#include "scree/scree.h"
#include <jansson.h>

#define SENTENCE_SIZE 512

typedef struct // what all values of one file share
{
	const char* file;
	char* sentence; // SENTENCE_SIZE characters: what is wrong
	Scope scope;    // names known to expressions
	uint64_t seed;
	uint32_t sites; // random() calls so far
	bool redraws;   // random() varies where there is no index
} Reader;

typedef struct Place // of a value in the file, a list upwards: attributes . crate . polygon [2]
{
	const struct Place* up; // null at the top
	const char* key;        // null for an element of a list
	int index;
} Place;
#define KEY(up, key)       (&(Place){(up), (key), 0})
#define ELEMENT(up, index) (&(Place){(up), NULL, (index)})

typedef struct
{
	double low, high;
	bool whole;   // only whole numbers
	bool floored; // the whole part counts
} Range;

// ranges that several keys share; sizes and coordinates as include/scree/scree.h has them
static const Range any_coordinate = {-SCREE_HUGE, SCREE_HUGE, false, false};
static const Range any_size = {0.001, SCREE_HUGE, false, false};
static const Range any_speed = {-1e6, 1e6, false, false};
static const Range not_negative = {0, 1e6, false, false};
static const Range any_angle = {-1e6, 1e6, false, false};

typedef struct // a number that may differ from item to item
{
	double constant;
	Expression* code; // null for a constant
	char* text;       // of the expression, and
	char* path;       // its place, for errors; null for a constant
	Range range;
} Number;

#if defined(__GNUC__)
#define READER_FORMAT(a, b) __attribute__((format(printf, a, b)))
#else
#define READER_FORMAT(a, b)
#endif

// Writes "FILE: PLACE: ..." as the sentence and returns false.
bool reader_fail(Reader* reader, const Place* place, const char* format, ...) READER_FORMAT(3, 4);

// Fails with "must be ..." after the value itself, shortened.
bool reader_fail_value(Reader* reader, const Place* place, const json_t* value, const char* must);

// What is wrong with a value for a range, as "must be ..."; null when nothing is.
const char* range_fault(Range range, double value, char* text, size_t size);

// Writes a place as "bodies[3].position[0]".
void place_text(const Place* place, char* text, size_t size);

// Checks that value is an object whose keys are all in the list, which ends with null.
bool reader_object(Reader* reader, const Place* place, const json_t* value, const char* const* keys);

// Each reads one value; the ones with a number take JSON numbers and strings with expressions.
bool reader_number(Reader* reader, const Place* place, const json_t* value, Range range, Number* number);
bool reader_constant(Reader* reader, const Place* place, const json_t* value, Range range, double* constant);
bool reader_vec(Reader* reader, const Place* place, const json_t* value, Range range, scree_vec* vec);
bool reader_string(Reader* reader, const Place* place, const json_t* value, const char** string);

void number_free(Number* number);

#endif
