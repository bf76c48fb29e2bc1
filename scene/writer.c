// SPDX-License-Identifier: MIT
// writer.c -- writes the members of structs as the keys of scene/format.def, those that differ from a default.
#include "scene/writer.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#define EXACT_WHOLE \
	((uint64_t)1 << 53) // whole numbers up to this one are exact in programs that read numbers as doubles

bool writer_try(Writer* writer, scree_status status)
{
	if (status != SCREE_OK)
		writer->status = status;
	return status == SCREE_OK;
}

bool writer_short(Writer* writer)
{
	writer->status = SCREE_ERROR_OUT_OF_MEMORY;
	return reader_fail(&writer->reader, NULL, "out of memory");
}

static bool check(Writer* writer, const Location* location, double value, Range range)
{
	char text[160];
	const char* fault = range_fault(range, value, text, sizeof text);
	return !fault || reader_fail(&writer->reader, location, "%.9g %s in a scene file", value, fault);
}

bool writer_vec(Writer* writer, const Location* location, const char* key, scree_vec v, Range range)
{
	if (!check(writer, ELEMENT(KEY(location, key), 0), (double)v.x, range) ||
	    !check(writer, ELEMENT(KEY(location, key), 1), (double)v.y, range))
		return false;
	text_key(&writer->text, key);
	text_pair(&writer->text, v.x, v.y, range.high);
	return true;
}

static bool same_rotation(scree_rot a, scree_rot b) { return memcmp(&a, &b, sizeof a) == 0; }

bool writer_rotation(Writer* writer, const Location* location, scree_rot rotation)
{
	float angle = scree_rot_get_angle(rotation);
	if (angle == 0.0f || !same_rotation(scree_rot_make(angle), rotation))
		return writer_vec(writer, location, "rotation", (scree_vec){rotation.c, rotation.s},
		                  (Range){-1.001, 1.001, false, false});
	text_key(&writer->text, "angle");
	text_float(&writer->text, angle, 1e6);
	return true;
}

// Returns the size of a key's member, bytes.
static size_t member_size(const FormatKey* key)
{
	switch (key->type)
	{
	case TYPE_PAIR:
		return sizeof(scree_vec);
	case TYPE_ROTATION:
		return sizeof(scree_rot);
	case TYPE_BOOLEAN:
		return sizeof(bool);
	case TYPE_BITS:
	case TYPE_USER:
		return sizeof(uint64_t);
	default:
		return key->store == STORE_INT64 || key->store == STORE_UINT64 ? 8 : 4;
	}
}

static bool is_nan(const char* member) { return *(const float*)member != *(const float*)member; }

// Returns true if a member has the bits of the default, or if both are NaN, which stands for a value that is not set.
static bool is_default(const FormatKey* key, const char* member, const char* base)
{
	bool number = key->store == STORE_FLOAT && (key->type == TYPE_NUMBER || key->type == TYPE_PAIR);
	return (number && is_nan(member) && is_nan(base)) || memcmp(member, base, member_size(key)) == 0;
}

static bool write_number(Writer* writer, const Location* location, const FormatKey* key, const char* member)
{
	bool real = key->store == STORE_FLOAT;
	double value = format_stored(member, 0, key->store);
	if (!check(writer, KEY(location, key->name), value, key->range))
		return false;
	text_key(&writer->text, key->name);
	if (real)
		text_float(&writer->text, (float)value, key->range.high);
	else
		text_whole(&writer->text, (int64_t)value);
	return true;
}

static void write_user(Text* text, const char* key, uint64_t user)
{
	char digits[24];
	text_key(text, key);
	snprintf(digits, sizeof digits, user > EXACT_WHOLE ? "\"0x%" PRIx64 "\"" : "%" PRIu64, user);
	text_add(text, digits);
}

// Writes the numbers of the bits that are set, or the names of these bits.
static void write_bits(Text* text, const FormatKey* key, uint64_t bits)
{
	text_key(text, key->name);
	text_add(text, "[");
	for (int k = 0; k < 64; ++k)
	{
		if (!(bits >> k & 1))
			continue;
		text_comma(text);
		if (key->names)
			text_string(text, key->names[k]);
		else
			text_whole(text, k);
	}
	text_add(text, "]");
}

static bool write_member(Writer* writer, const Location* location, const FormatKey* key, const char* member)
{
	Text* text = &writer->text;
	switch (key->type)
	{
	case TYPE_NUMBER:
		return write_number(writer, location, key, member);
	case TYPE_PAIR:
		return writer_vec(writer, location, key->name, *(const scree_vec*)member, key->range);
	case TYPE_ROTATION:
		return writer_rotation(writer, location, *(const scree_rot*)member);
	case TYPE_BOOLEAN:
		text_key(text, key->name);
		text_add(text, *(const bool*)member ? "true" : "false");
		return true;
	case TYPE_BITS:
		write_bits(text, key, *(const uint64_t*)member);
		return true;
	case TYPE_USER:
		write_user(text, key->name, *(const uint64_t*)member);
		return true;
	case TYPE_NAME:
		text_key(text, key->name);
		text_string(text, key->names[*(const uint32_t*)member]);
		return true;
	case TYPE_NAMES:
		write_bits(text, key, *(const uint32_t*)member);
		return true;
	case TYPE_TEXT:
	case TYPE_OTHER:
		break;
	}
	return true;
}

bool writer_object(Writer* writer, const Location* location, FormatObject object, const void* item, const void* base)
{
	for (const FormatKey* key = format_keys(object); key->object == object; ++key)
	{
		// a rotation has two keys, of which TYPE_ROTATION writes one
		bool angle = key->type == TYPE_NUMBER && key->store == STORE_ROTATION;
		const char* member = (const char*)item + key->offset;
		if (key->special || angle ||
		    (key->need != NEED_MUST && is_default(key, member, (const char*)base + key->offset)))
			continue;
		if (!write_member(writer, location, key, member))
			return false;
	}
	return true;
}
