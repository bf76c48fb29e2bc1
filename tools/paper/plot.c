// SPDX-License-Identifier: MIT
// plot.c -- draws the figures of scree_paper from their CSV with gnuplot (Debian: gnuplot-nox).
#include "tools/paper/plot.h"
#include "cli/common/options.h"
#include "tools/paper/plot_bars.h"
#include "tools/paper/plot_curves.h"
#include <signal.h>
#include <stdlib.h>
#include <string.h>

// Writes the path of the CSV with another extension.
static void path_of(const char* csv, const char* ending, char* path, size_t size)
{
	size_t length = strlen(csv);
	if (length > 4 && strcmp(csv + length - 4, ".csv") == 0)
		length -= 4;
	snprintf(path, size, "%.*s.%s", (int)length, csv, ending);
}

static int draw(const Table* table, const char* csv, int number)
{
	static const char* const terminals[][2] = {
	    {"svg", "svg size 1100,1000 font 'Helvetica,19' linewidth 1.6 background 'white'"},
	    {"png", "pngcairo size 1650,1500 font 'Helvetica,19' fontscale 1.13 linewidth 2"},
	};
	char paths[2][1024];
	// gnuplot may end before it has read all commands; then writing must fail without a signal
	signal(SIGPIPE, SIG_IGN);
	for (int k = 0; k < 2; ++k)
	{
		path_of(csv, terminals[k][0], paths[k], sizeof paths[k]);
		FILE* to = popen("gnuplot", "w");
		if (!to)
			return EXIT_FAILED;
		fprintf(to, "set terminal %s\nset output \"%s\"\n", terminals[k][1], paths[k]);
		if (number == 5)
			plot_curves(to, table);
		else
			plot_bars(to, table);
		if (pclose(to) != 0)
		{
			fprintf(stderr, "scree_paper: gnuplot could not draw %s\n", csv);
			return EXIT_FAILED;
		}
	}
	printf("%s is drawn as %s and %s\n", csv, paths[0], paths[1]);
	return EXIT_GOOD;
}

int plot_figure(const char* csv, int number)
{
	Table* table = calloc(1, sizeof *table);
	if (!table)
	{
		fprintf(stderr, "scree_paper: out of memory for the rows of %s\n", csv);
		return EXIT_FAILED;
	}
	int code = table_read(csv, table);
	if (code == EXIT_GOOD && number == 5)
		table_print_crossovers(table);
	if (code == EXIT_GOOD && system("command -v gnuplot >/dev/null 2>&1") != 0)
		fprintf(stderr, "scree_paper: %s is not drawn, because gnuplot was not found (Debian: gnuplot-nox)\n", csv);
	else if (code == EXIT_GOOD)
		code = draw(table, csv, number);
	free(table);
	return code;
}
