// SPDX-License-Identifier: MIT
// fail_hook.c -- reports failed calls of the user to the hook of scree_fail_hook_set.
#include "platform/fail_hook.h"
#include "platform/error.h"
#include <string.h>

#ifndef SCREE_SMALL

atomic_bool fail_hooked;
static scree_fail_hook hook;
static void* hook_context;
static _Thread_local int depth; // number of calls that this thread is in; 1: a call of the user, or the hook

void scree_fail_hook_set(scree_fail_hook new_hook, void* context)
{
	hook = new_hook;
	hook_context = context;
	atomic_store(&fail_hooked, new_hook != NULL);
}

void fail_hook_enter(void) { ++depth; }

scree_status fail_hook_leave(const char* function, scree_status status)
{
	if (status != SCREE_OK && depth == 1 && hook)
	{
		char name[64] = "";
		size_t length = strlen(function), end = strlen("_sized");
		if (length > end && strcmp(function + length - end, "_sized") == 0)
			length -= end;
		memcpy(name, function, length < sizeof name ? length : sizeof name - 1);
		const Sentence kept = sentence_keep(); // calls of the hook may fail too
		hook(name, status, kept.text, hook_context);
		sentence_restore(&kept);
	}
	--depth;
	return status;
}
#endif

void scree_call_begin(void) { fail_hook_enter(); }

scree_status scree_call_end(const char* function, scree_status status, const char* sentence)
{
	if (status != SCREE_OK && sentence)
		fail(status, "%s", sentence);
	return fail_hook_leave(function, status);
}

scree_status scree_hooks_set(const scree_hooks* hooks) { REPORTED("scree_hooks_set", hooks_set(hooks)) }
