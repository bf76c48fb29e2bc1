// SPDX-License-Identifier: MIT
// plot_text.c -- writes names, times and numbers for both figures.
#include "tools/paper/plot_text.h"
#include <stdio.h>

const char* const plot_pipelines[FIGURE_PIPELINES] = {"paper", "Scree"};
const char* const plot_scenes[FIGURE_SCENES] = {"boxes that drift", "pyramids of ten boxes"};

void plot_duration(double ms, char text[PLOT_TEXT])
{
	static const struct
	{
		double ms;
		const char* name;
	} units[] = {{86400e3, "days"}, {3600e3, "h"}, {60e3, "min"}, {1e3, "s"}, {1, "ms"}};
	int k = 0;
	while (k < 4 && ms < units[k].ms)
		++k;
	double number = ms / units[k].ms;
	snprintf(text, PLOT_TEXT, number < 10 ? "%.2g %s" : "%.0f %s", number, units[k].name);
}

void plot_number(double number, char text[PLOT_TEXT])
{
	char digits[PLOT_TEXT];
	int length = snprintf(digits, sizeof digits, "%.0f", number), k = 0;
	for (const char* digit = digits; *digit && k < PLOT_TEXT - 2; ++digit)
	{
		text[k++] = *digit;
		if (--length > 0 && length % 3 == 0)
			text[k++] = ',';
	}
	text[k] = 0;
}
