// SPDX-License-Identifier: MIT
// format.h -- declares the table of the keys of scene files, and reads the values of keys that need no special code.
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

typedef enum // rule for the presence of a key in an object
{
	NEED_MAY,
	NEED_MUST,
	NEED_EITHER, // the object has exactly one of the keys with this need
	NEED_ALONE,  // only in a body with the key "attribute"; otherwise each collidable of the body has this key
} FormatNeed;

typedef enum
{
	TYPE_NUMBER,   // a number or an expression, in a range
	TYPE_PAIR,     // a list of two numbers
	TYPE_ROTATION, // a cosine and a sine, equal in all items; the object has no key "angle" beside it
	TYPE_BOOLEAN,
	TYPE_BITS,  // a list of bit numbers
	TYPE_USER,  // a word of 64 bits: a whole number, or a text such as "0x1f"
	TYPE_NAME,  // a name from a list
	TYPE_NAMES, // a list of names; each name stands for a bit
	TYPE_TEXT,  // a string that nothing reads
	TYPE_OTHER,
} FormatType;

typedef enum // C types of the numbers of a struct
{
	STORE_NONE, // the member is not a number
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
	Range range;              // limits of numbers, or of the number of points
	const char* const* names; // names of a value; the last is null
	bool special;             // true if special code of the object reads the key
	FormatStore store;
	size_t offset; // offset of the member in the struct of the object
} FormatKey;

typedef struct // a number that differs between items
{
	size_t offset; // offset of the member in the struct of an item
	FormatStore store;
	Number number;
} FormatNumber;

typedef struct
{
	FormatNumber* list;
	int count;
} FormatNumbers;

#define LIST(array, ...) extern const char* const array[]; // the last name is null
#include "scene/format.def"

// Returns the first key of an object. The other keys of the object follow, then the keys of the next object.
const FormatKey* format_keys(FormatObject object);

// Returns the range of the numbers of a key; the object must have a key with this name.
Range format_range(FormatObject object, const char* name);

// Checks that a value is an object, that all its keys are allowed, and that its texts are strings.
bool format_check(Reader* reader, const Location* location, const json_t* value, FormatObject object);

// Sets *target to the struct of an object without keys: the default values.
void format_default(FormatObject object, void* target);

// Reads all keys of an object, except the special keys, into the struct at this offset in an item. numbers: gets the
// numbers that differ between items, which items_store evaluates; null if no loop index exists here. The caller frees
// the list, also on failure.
bool format_read(Reader* reader, const Location* location, const json_t* value, FormatObject object, void* item,
                 size_t offset, FormatNumbers* numbers);
void format_free(FormatNumbers* numbers);

// Writes a number into a member of a struct, in the C type of the member.
void format_store(void* item, size_t offset, FormatStore store, double value);

// Returns the number in a member of a struct, NAN if the member is not a number. A rotation is an angle.
double format_stored(const void* item, size_t offset, FormatStore store);

#endif
