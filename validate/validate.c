// SPDX-License-Identifier: MIT
// validate.c -- the list of experiments, and the rows that they print.
#include "validate.h"
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define X(name, shows) void name##_experiment(Validation* v);
#include "experiments.def"
#undef X

#define X(name, shows) {#name, shows, name##_experiment},
const Experiment validate_experiments[] = {
#include "experiments.def"
};
#undef X
const int validate_count = (int)(sizeof validate_experiments / sizeof validate_experiments[0]);

const Experiment* validate_find(const char* name)
{
	for (int k = 0; k < validate_count; ++k)
	{
		if (strcmp(validate_experiments[k].name, name) == 0)
			return &validate_experiments[k];
	}
	return NULL;
}

void validate_heading(FILE* out)
{
	fprintf(out, "experiment,case,engine,quantity,value,unit,limit,result,steps,hash,where\n");
}

bool validate_run(Validation* v, const Experiment* experiment)
{
	int before = v->failures;
	v->experiment = experiment->name;
	begin(v, "%s", experiment->name);
	experiment->run(v);
	return !v->broken && v->failures == before;
}

// A comma must not make a column.
static void cell(char* text)
{
	for (; *text; ++text)
		*text = *text == ',' ? ' ' : *text;
}

void begin(Validation* v, const char* format, ...)
{
	va_list list;
	va_start(list, format);
	vsnprintf(v->text, sizeof v->text, format, list);
	va_end(list);
	cell(v->text);
	v->where[0] = 0;
	v->steps = 0;
	v->hash = 0;
}

void where(Validation* v, const char* format, ...)
{
	va_list list;
	va_start(list, format);
	vsnprintf(v->where, sizeof v->where, format, list);
	va_end(list);
	cell(v->where);
}

uint64_t validate_hash(Validation* v)
{
	if (!v->lab)
		return v->hash;
	return v->hash * 0x100000001b3u ^ lab_hash(v->lab); // of a single world its own
}

void row(Validation* v, const char* quantity, double value, const char* unit, Limit limit, double bound)
{
	if (v->broken)
		return;
	bool good = limit == SHOWN || (limit == AT_MOST && value <= bound) || (limit == AT_LEAST && value >= bound);
	fprintf(v->out, "%s,%s,%s,%s,%.5g,%s,", v->experiment, v->text, v->engine->name, quantity, value, unit);
	if (limit != SHOWN)
		fprintf(v->out, "%s %.5g", limit == AT_MOST ? "<=" : ">=", bound);
	fprintf(v->out, ",%s,%" PRId64 ",%016" PRIx64 ",%s\n",
	        limit == SHOWN ? "shown"
	        : good         ? "pass"
	                       : "fail",
	        v->steps, validate_hash(v), v->where);
	fflush(v->out);
	v->failures += !good;
	v->where[0] = 0;
}

static int rising(const void* a, const void* b)
{
	double x = *(const double*)a, y = *(const double*)b;
	return (x > y) - (x < y);
}

double middle(double* values, int count)
{
	qsort(values, (size_t)count, sizeof *values, rising);
	return values[count / 2];
}

void* demand(void* memory)
{
	if (memory)
		return memory;
	fprintf(stderr, "scree validate: out of memory\n");
	exit(1);
}

double random_between(uint64_t* seed, double low, double high)
{
	uint64_t z = *seed += 0x9e3779b97f4a7c15u;
	z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
	z = (z ^ z >> 27) * 0x94d049bb133111ebu;
	return low + (high - low) * (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}
