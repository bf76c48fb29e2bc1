// SPDX-License-Identifier: MIT
// program.c -- calls with named arguments; writes programs as text and reads them.
#include "programs/program.h"
#include <stdlib.h>
#include <string.h>

static const char* const texts[CALL_KINDS][2] = {
#define X(name, arguments) {#name, arguments},
#include "programs/calls.def"
#undef X
};

static CallInfo infos[CALL_KINDS];

static void info_fill(CallInfo* info, const char* text)
{
	while (*text)
	{
		char name[16] = "";
		int used = 0;
		float value = 0.0f;
		if (info->count == MOST_ARGUMENTS || sscanf(text, " %15[a-z0-9_]=%f%n", name, &value, &used) != 2)
		{
			fprintf(stderr, "calls.def: %s: cannot read \"%s\"\n", info->name, text);
			abort();
		}
		memcpy(info->names[info->count], name, sizeof name);
		info->values[info->count++] = value;
		text += used;
		text += strspn(text, " ");
	}
}

const CallInfo* call_info(CallKind kind)
{
	CallInfo* info = &infos[kind];
	if (!info->name)
	{
		info->name = texts[kind][0];
		info_fill(info, texts[kind][1]);
	}
	return info;
}

Call call_make(CallKind kind)
{
	Call call = {.kind = kind};
	memcpy(call.value, call_info(kind)->values, sizeof call.value);
	return call;
}

// Returns the position of an argument, or -1 if the call has no argument with this name.
static int place_of(const CallInfo* info, const char* name)
{
	for (int k = 0; k < info->count; ++k)
		if (strcmp(info->names[k], name) == 0)
			return k;
	return -1;
}

static int place_of_call(const Call* call, const char* name)
{
	int place = place_of(call_info(call->kind), name);
	if (place < 0)
	{
		fprintf(stderr, "calls.def: %s has no argument %s\n", texts[call->kind][0], name);
		abort();
	}
	return place;
}

float call_value(const Call* call, const char* name) { return call->value[place_of_call(call, name)]; }
void call_set(Call* call, const char* name, float value) { call->value[place_of_call(call, name)] = value; }

void program_add(Program* program, Call call)
{
	if (program->count == program->capacity)
	{
		program->capacity = 2 * program->capacity + 64;
		program->calls = realloc(program->calls, (size_t)program->capacity * sizeof *program->calls);
		if (!program->calls)
			abort();
	}
	program->calls[program->count++] = call;
}

void program_copy(Program* to, const Program* from)
{
	to->count = 0;
	for (int k = 0; k < from->count; ++k)
		program_add(to, from->calls[k]);
}

void program_close(Program* program)
{
	free(program->calls);
	*program = (Program){0};
}

void program_write(const Program* program, FILE* file)
{
	for (int k = 0; k < program->count; ++k)
	{
		const Call* call = &program->calls[k];
		const CallInfo* info = call_info(call->kind);
		fputs(info->name, file);
		for (int i = 0; i < info->count; ++i)
			if (memcmp(&call->value[i], &info->values[i], sizeof(float)) != 0)
				fprintf(file, " %s=%.9g", info->names[i], (double)call->value[i]);
		fputc('\n', file);
	}
}

static bool line_read(char* line, Call* call, char error[256])
{
	char* rest = NULL;
	const char* name = strtok_r(line, " \t\r\n", &rest);
	int kind = 0;
	while (kind < CALL_KINDS && strcmp(texts[kind][0], name) != 0)
		++kind;
	if (kind == CALL_KINDS)
	{
		snprintf(error, 256, "there is no call \"%.100s\"", name);
		return false;
	}
	*call = call_make((CallKind)kind);
	for (char* word; (word = strtok_r(NULL, " \t\r\n", &rest));)
	{
		char* value = strchr(word, '=');
		char* end = value;
		if (value)
			*value++ = '\0';
		int place = place_of(call_info(call->kind), word);
		float x = value ? strtof(value, &end) : 0.0f;
		if (!value || place < 0 || end == value || *end)
		{
			snprintf(error, 256, "%s: cannot read argument \"%.100s\"", name, word);
			return false;
		}
		call->value[place] = x;
	}
	return true;
}

bool program_read(Program* program, FILE* file, char error[256])
{
	char line[1024];
	program->count = 0;
	while (fgets(line, sizeof line, file))
	{
		if (line[strspn(line, " \t\r\n")] == '\0' || line[0] == '#')
			continue;
		Call call;
		if (!line_read(line, &call, error))
			return false;
		if (program->count == 0 && call.kind != CALL_world)
			program_add(program, call_make(CALL_world));
		program_add(program, call);
	}
	if (program->count > 0)
		return true;
	snprintf(error, 256, "it has no calls");
	return false;
}
