// SPDX-License-Identifier: MIT
// heading.c -- reads the title and the parameters of a scene file without loading the scene.
#include "scene/heading.h"
#include "scene/clean_text.h"
#include "scene/reader.h"
#include <stdio.h>
#include <string.h>

// Copies an expression without its blanks, because blanks separate the parameters in the text.
static void append_tight(char* text, size_t size, const char* expression)
{
	for (; *expression && size > 1; ++expression)
		if (*expression != ' ' && *expression != '\t')
		{
			*text++ = *expression;
			--size;
		}
	*text = 0;
}

bool scene_heading(const char* path, char* title, size_t title_size, char* parameters, size_t parameters_size,
                   char* sentence)
{
	json_t* root = reader_load(path, sentence);
	if (!root)
	{
		clean_text(sentence);
		return false;
	}
	const char* text = json_string_value(json_object_get(root, "title"));
	snprintf(title, title_size, "%s", text ? text : "");
	clean_text(title);
	parameters[0] = 0;
	json_t* entry;
	json_object_foreach(json_object_get(root, "parameters"), text, entry)
	{
		size_t length = strlen(parameters);
		const json_t* value = json_object_get(entry, "default");
		snprintf(parameters + length, parameters_size - length, "%s%s=", length ? " " : "", text);
		length = strlen(parameters);
		if (json_is_string(value))
			append_tight(parameters + length, parameters_size - length, json_string_value(value));
		else
			snprintf(parameters + length, parameters_size - length, "%.9g", json_number_value(value));
	}
	clean_text(parameters);
	json_decref(root);
	return true;
}

// Writes a limit of a parameter, which may be a number or an expression. without: text for a parameter without this
// limit.
static void write_bound(const json_t* bound, const char* without, char text[32])
{
	if (json_is_string(bound))
		snprintf(text, 32, "%s", json_string_value(bound));
	else if (json_is_number(bound))
		snprintf(text, 32, "%.6g", json_number_value(bound));
	else
		snprintf(text, 32, "%s", without);
}

bool scene_parameter_help(const char* path, const char* name, char* help, size_t size, char* sentence)
{
	json_t* root = reader_load(path, sentence);
	if (!root)
	{
		clean_text(sentence);
		return false;
	}
	const json_t* entry = json_object_get(json_object_get(root, "parameters"), name);
	const char* text = json_string_value(json_object_get(entry, "description"));
	char least[32], most[32];
	write_bound(json_object_get(entry, "min"), "any", least);
	write_bound(json_object_get(entry, "max"), "any", most);
	snprintf(help, size, "%s%s%s to %s%s", text ? text : "", text ? ": " : "", least, most,
	         json_is_true(json_object_get(entry, "integer")) ? ", whole numbers" : "");
	clean_text(help);
	json_decref(root);
	return true;
}
