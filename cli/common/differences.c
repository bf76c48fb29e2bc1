// SPDX-License-Identifier: MIT
// differences.c -- prints the differences of two snapshots.
#include "differences.h"
#include "library_error.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

// Prints a value in hexadecimal digits, and as a float if it has four bytes.
static void print_value(uint64_t value, int bytes)
{
	printf("%0*" PRIx64, 2 * bytes, value);
	uint32_t word = (uint32_t)value;
	float real;
	memcpy(&real, &word, sizeof real);
	if (bytes == 4)
		printf(" (%.9g)", (double)real);
}

static void print_one(const scree_difference* d)
{
	char name[sizeof d->column + sizeof d->word + 2];
	snprintf(name, sizeof name, "%s %s", d->column, d->word);
	printf("%-34s ", name);
	if (d->count_a != d->count_b)
		printf("%d and %d items, ", d->count_a, d->count_b);
	printf("%d of %d differ; item %d", d->items, d->count_a > d->count_b ? d->count_a : d->count_b, d->item);
	if (d->offset > 0)
		printf(", byte %d", d->offset);
	printf(": ");
	print_value(d->value_a, d->bytes);
	printf(" | ");
	print_value(d->value_b, d->bytes);
	printf("\n");
}

int print_differences(const void* a, size_t size_a, const void* b, size_t size_b)
{
	int count, more;
	int code = report(scree_snapshots_compare(a, size_a, b, size_b, NULL, 0, &count));
	if (code != EXIT_GOOD || count == 0)
		return code;
	scree_difference* list = calloc((size_t)count, sizeof *list);
	if (!list)
	{
		fprintf(stderr, "%s: no memory for %d differences\n", program_name, count);
		return EXIT_FAILED;
	}
	code = report(scree_snapshots_compare(a, size_a, b, size_b, list, count, &more));
	for (int k = 0; k < count && code == EXIT_GOOD; ++k)
		print_one(list + k);
	free(list);
	return code == EXIT_GOOD ? EXIT_FAILED : code;
}
