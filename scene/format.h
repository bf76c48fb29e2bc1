// SPDX-License-Identifier: MIT
// format.h -- the table of the keys of scene files, and the reader of the keys without code of their own.
#ifndef FORMAT_H
#define FORMAT_H
#include "scene/reader.h"
#include "scene/scene.h"

typedef enum // the JSON objects of a scene file
{
#define OBJECT(object, struct, value, text) OBJECT_##object,
#define PLAIN(object, text)                 OBJECT_##object,
#include "scene/format.def"
	FORMAT_OBJECTS,
} FormatObject;

typedef enum // presence of a key in an object
{
	NEED_MAY,
	NEED_MUST,
	NEED_EITHER, // exactly one of these keys
	NEED_ALONE,  // only in a body with an attribute: each of several collidables has its own
} FormatNeed;

typedef enum
{
	TYPE_NUMBER, // a number or an expression, in a range
	TYPE_PAIR,   // a list of two numbers
	TYPE_BOOLEAN,
	TYPE_BITS,  // a list of bit numbers
	TYPE_NAME,  // one of a list of names
	TYPE_NAMES, // a list of names, each for one bit
	TYPE_OTHER,
} FormatType;

typedef enum // C types of the numbers of a struct
{
	STORE_NONE, // not a number
	STORE_FLOAT,
	STORE_ROTATION, // scree_rot, from radians
	STORE_INT,
	STORE_INT64,
	STORE_UINT32,
	STORE_UINT64,
} FormatStore;

typedef struct
{
	FormatObject object;
	const char* name;
	FormatNeed need;
	FormatType type;
	Range range;              // limits of numbers, or of the count of points
	const char* const* names; // ends with null
	bool special;             // true if the code of the object reads it
	FormatStore store;
	size_t offset; // place of the member in the struct of the object
} FormatKey;

typedef struct // a number that differs between items
{
	size_t offset; // place of the member in the struct of an item
	FormatStore store;
	Number number;
} FormatNumber;

typedef struct
{
	FormatNumber* list;
	int count;
} FormatNumbers;

#define LIST(array, ...) extern const char* const array[]; // ends with null
#include "scene/format.def"

// Returns the first key of an object. Its other keys follow, then those of another object.
const FormatKey* format_keys(FormatObject object);

// Returns the range of the numbers of a key, which the object must have.
Range format_range(FormatObject object, const char* name);

// Checks that a value is an object, and that all its keys are in the format.
bool format_check(Reader* reader, const Location* location, const json_t* value, FormatObject object);

// Writes the value of an object's struct without any key.
void format_default(FormatObject object, void* target);

// Reads all keys of an object except the special ones into its struct, which is at an offset in an item. Numbers that
// differ between items are added to a list, for items_store; a null list means that no index exists here. The caller
// frees the list, also on failure.
bool format_read(Reader* reader, const Location* location, const json_t* value, FormatObject object, void* item,
                 size_t offset, FormatNumbers* numbers);
void format_free(FormatNumbers* numbers);

// Writes a number into a struct.
void format_store(void* item, size_t offset, FormatStore store, double value);

#endif
