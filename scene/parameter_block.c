// SPDX-License-Identifier: MIT
// parameter_block.c -- reads the parameters and constants of a scene: names that its expressions use.
#include "scene/parameter_block.h"
#include "scene/format.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool add_name(Reader* reader, const Location* location, const char* text, double value)
{
	if (!name_is_allowed(text) || scope_find(&reader->scope, text))
		return reader_fail(reader, location, "the name is taken, or is not 1 to %d small letters, digits and _",
		                   NAME_SIZE - 1);
	if (reader->scope.count == MAX_NAMES)
		return reader_fail(reader, location, "more than %d names", MAX_NAMES);
	Name* name = &reader->scope.names[reader->scope.count++];
	*name = (Name){.slot = -1, .value = value};
	strcpy(name->text, text);
	return true;
}

// Reads the value that the user set for a parameter. Fails if it is not a number in the range.
static bool read_setting(Reader* reader, const SceneSetting* setting, Range range, double* value)
{
	char fault[160];
	const Scope no_names = {0};
	uint32_t sites = 0;
	Expression* expression = expression_compile(setting->value, &no_names, &sites, fault, sizeof fault);
	bool good = expression && expression_is_constant(expression, value);
	free(expression);
	if (good && !range_fault(range, *value, fault, sizeof fault))
		return true;
	snprintf(reader->sentence, SENTENCE_SIZE, "--set %.60s=%.60s: %.160s", setting->name, setting->value,
	         !expression ? fault
	         : good      ? fault
	                     : "must be a number");
	return false;
}

bool parameters_read(Reader* reader, const json_t* root, const SceneSetting* settings, int count)
{
	const json_t* parameters = json_object_get(root, "parameters");
	const Location* location = KEY(NULL, "parameters");
	char known[256] = "";
	if (parameters && !json_is_object(parameters))
		return reader_fail_value(reader, location, parameters, "must be an object, { ... }");

	const char* text;
	json_t* entry;
	json_object_foreach((json_t*)parameters, text, entry)
	{
		const Location* at = KEY(location, text);
		Range range = format_range(OBJECT_parameter, "default");
		bool integer = false;
		const json_t* low = json_object_get(entry, "min");
		const json_t* high = json_object_get(entry, "max");
		double value;
		if (!format_check(reader, at, entry, OBJECT_parameter) ||
		    !reader_boolean(reader, KEY(at, "integer"), json_object_get(entry, "integer"), &integer))
			return false;
		range.whole = integer;
		if (low && !reader_constant(reader, KEY(at, "min"), low, range, &range.low))
			return false;
		if (high && !reader_constant(reader, KEY(at, "max"), high, range, &range.high))
			return false;
		if (!json_object_get(entry, "default"))
			return reader_fail(reader, at, "default is missing");
		if (!reader_constant(reader, KEY(at, "default"), json_object_get(entry, "default"), range, &value))
			return false;
		for (int k = 0; k < count; ++k)
		{
			if (strcmp(settings[k].name, text) == 0 && !read_setting(reader, &settings[k], range, &value))
				return false;
		}
		if (!add_name(reader, at, text, value))
			return false;
		snprintf(known + strlen(known), sizeof known - strlen(known), "%s%s", known[0] ? ", " : "", text);
	}
	for (int k = 0; k < count; ++k)
	{
		if (!scope_find(&reader->scope, settings[k].name))
			return reader_fail(reader, NULL, "no parameter \"%.60s\" to set; %s%s", settings[k].name,
			                   known[0] ? "there are " : "the scene has none", known);
	}
	return true;
}

bool constants_read(Reader* reader, const json_t* root)
{
	const json_t* constants = json_object_get(root, "constants");
	const Location* location = KEY(NULL, "constants");
	if (constants && !json_is_object(constants))
		return reader_fail_value(reader, location, constants, "must be an object, { ... }");
	const char* text;
	json_t* entry;
	json_object_foreach((json_t*)constants, text, entry)
	{
		double value;
		if (!reader_constant(reader, KEY(location, text), entry, any_constant, &value) ||
		    !add_name(reader, KEY(location, text), text, value))
			return false;
	}
	return true;
}
