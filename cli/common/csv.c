// SPDX-License-Identifier: MIT
// csv.c -- splits rows of CSV files into cells, and writes texts as cells.
#include "csv.h"
#include <string.h>

int csv_cut(char* line, char* cells[CSV_CELLS])
{
	int count = 0;
	bool more = true;
	line[strcspn(line, "\r\n")] = 0;
	for (int k = 0; k < CSV_CELLS; ++k)
	{
		count += more;
		cells[k] = line;
		line += strcspn(line, ",");
		more = *line != 0;
		if (more)
			*line++ = 0;
	}
	return count;
}

void csv_cell(char* text)
{
	for (; *text; ++text)
		*text = *text == ',' ? ' ' : *text;
}

void settings_text(const Options* options, char* text, size_t size)
{
	text[0] = 0;
	for (int k = 0; k < options->setting_count; ++k)
		snprintf(text + strlen(text), size - strlen(text), "%s%s=%s", k > 0 ? " " : "", options->settings[k].name,
		         options->settings[k].value);
	if (options->sleep != SLEEP_OF_SCENE)
		snprintf(text + strlen(text), size - strlen(text), "%s--sleep=%s", *text ? " " : "",
		         options->sleep == SLEEP_ON ? "on" : "off");
	csv_cell(text);
}
