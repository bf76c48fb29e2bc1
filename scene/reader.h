// SPDX-License-Identifier: MIT
// reader.h -- reads and checks JSON values; errors name the location in the file.
#ifndef READER_H
#define READER_H
#include "scene/expression.h"
#include "scree/scree.h"
#include <jansson.h>

#define SENTENCE_SIZE 512

typedef struct // one file that is being read
{
	const char* file;
	char* sentence; // SENTENCE_SIZE characters for an error
	Scope scope;    // names known to expressions
	uint64_t seed;
	uint32_t sites; // random() calls so far
	bool redraws;   // expressions are evaluated again and again, so that random() is no constant
} Reader;

// Of a value in the file, linked to the location of its parent: attributes . crate . polygon [2].
typedef struct Location
{
	const struct Location* up; // null at the top
	const char* key;           // null for an element of a list
	int index;
} Location;
#define KEY(up, key)       (&(Location){(up), (key), 0})
#define ELEMENT(up, index) (&(Location){(up), NULL, (index)})

typedef struct
{
	double low, high;
	bool whole;   // only whole numbers
	bool floored; // only the whole part is used
} Range;

// ranges that several keys share; sizes and coordinates as include/scree/scree.h has them
static const Range any_coordinate = {-SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE, false, false};
static const Range any_size = {0.001, SCREE_MAX_COORDINATE, false, false};
static const Range any_speed = {-1e6, 1e6, false, false};
static const Range not_negative = {0, 1e6, false, false};
static const Range any_angle = {-1e6, 1e6, false, false};

typedef struct // a number that may differ between items
{
	double constant;
	Expression* code; // null for a constant
	char* text;       // of the expression, and
	char* path;       // its location, for errors; null for a constant
	Range range;
} Number;

#if defined(__GNUC__)
#define READER_FORMAT(a, b) __attribute__((format(printf, a, b)))
#else
#define READER_FORMAT(a, b)
#endif

// Writes "FILE: PLACE: ..." as the sentence and returns false.
bool reader_fail(Reader* reader, const Location* location, const char* format, ...) READER_FORMAT(3, 4);

// Fails with the value, shortened, and "must be ...".
bool reader_fail_value(Reader* reader, const Location* location, const json_t* value, const char* must);

// Why a value is outside a range, as "must be ..."; null if it is inside.
const char* range_fault(Range range, double value, char* text, size_t size);

// Writes a location as "bodies[3].position[0]".
void location_text(const Location* location, char* text, size_t size);

// Checks that value is an object whose keys are all in the list, which ends with null.
bool reader_object(Reader* reader, const Location* location, const json_t* value, const char* const* keys);

// Each reads one value. Numbers may be JSON numbers or strings with expressions.
bool reader_number(Reader* reader, const Location* location, const json_t* value, Range range, Number* number);
bool reader_constant(Reader* reader, const Location* location, const json_t* value, Range range, double* constant);
bool reader_vec(Reader* reader, const Location* location, const json_t* value, Range range, scree_vec* vec);
bool reader_string(Reader* reader, const Location* location, const json_t* value, const char** string);
bool reader_boolean(Reader* reader, const Location* location, const json_t* value,
                    bool* boolean); // stays as it is without a value

// Read a member of an object: a number, which is missing without the member, or a list of two numbers, which are 0 then.
bool reader_member(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                   double missing, Number* number);
bool reader_pair(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                 Number pair[2]);

// Reads a member that is a list of bit numbers, because a JSON number cannot hold 64 bits. Without it bits stay as they are.
bool reader_bits(Reader* reader, const Location* location, const json_t* object, const char* key, uint64_t* bits);

void number_free(Number* number);

#endif
