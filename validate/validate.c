// SPDX-License-Identifier: MIT
// validate.c -- lists the experiments, runs them, and prints rows of results.
#include "validate.h"
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
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

void peak_take(Peak* peak, double value, const char* at)
{
	if (value <= peak->value || peak->value != peak->value)
		return;
	peak->value = value;
	snprintf(peak->at, sizeof peak->at, "%s", at);
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

// Replaces commas by spaces, because commas separate the columns.
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
	        v->steps, lab_case_hash(v), v->where);
	fflush(v->out);
	v->failures += !good;
	v->where[0] = 0;
}
