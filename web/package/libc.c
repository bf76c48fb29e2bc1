// SPDX-License-Identifier: MIT
// libc.c -- replaces parts of the C library: formatted text, whose numbers JavaScript writes, and the log.
//
// Emscripten's printf and strtof compute in long double, which makes the compressed package 10 kB larger.
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LOG_BYTES    1024
#define NUMBER_BYTES 64

#define IMPORT(name) __attribute__((import_module("scree"), import_name(#name))) js_##name

// Writes a number as printf does, and returns the length of the text. kind: the conversion, 'g' or 'f'.
int IMPORT(number)(double value, int kind, int precision, char* text);
double IMPORT(parse)(const char* text);
void IMPORT(log)(const char* text);

typedef struct
{
	char* text;
	size_t size, length;
} Text;

static void add(Text* t, const char* s, size_t count)
{
	for (size_t k = 0; k < count; ++k, ++t->length)
		if (t->length + 1 < t->size)
			t->text[t->length] = s[k];
}

static void add_integer(Text* t, unsigned long long value, unsigned base, int width)
{
	char digits[NUMBER_BYTES];
	int at = NUMBER_BYTES;
	for (; value > 0 || at == NUMBER_BYTES || NUMBER_BYTES - at < width; value /= base)
		digits[--at] = "0123456789abcdef"[value % base];
	add(t, digits + at, (size_t)(NUMBER_BYTES - at));
}

// Formats %c %d %f %g %s %u %x with precision, zero padding, l, ll and z; Scree's messages contain no other
// conversions.
int vsnprintf(char* text, size_t size, const char* format, va_list arguments)
{
	Text t = {text, size, 0};
	for (const char* f = format; *f; ++f)
	{
		if (*f != '%')
		{
			add(&t, f, 1);
			continue;
		}
		int width = 0, precision = -1, wide = 0;
		for (++f; *f >= '0' && *f <= '9'; ++f)
			width = 10 * width + *f - '0';
		if (*f == '.')
		{
			precision = 0;
			if (*++f == '*')
			{
				precision = va_arg(arguments, int);
				++f;
			}
			for (; *f >= '0' && *f <= '9'; ++f)
				precision = 10 * precision + *f - '0';
		}
		for (; *f == 'l' || *f == 'z'; ++f)
			wide += *f == 'l';
		if (*f == 's')
		{
			const char* s = va_arg(arguments, const char*);
			add(&t, s, precision < 0 ? strlen(s) : strnlen(s, (size_t)precision));
		}
		else if (*f == 'g' || *f == 'f')
		{
			char number[NUMBER_BYTES];
			add(&t, number, (size_t)js_number(va_arg(arguments, double), *f, precision < 0 ? 6 : precision, number));
		}
		else if (*f == 'd')
		{
			long long value = wide > 1 ? va_arg(arguments, long long) : va_arg(arguments, int);
			if (value < 0)
				add(&t, "-", 1);
			add_integer(&t, value < 0 ? 0 - (unsigned long long)value : (unsigned long long)value, 10, width);
		}
		else if (*f == 'u' || *f == 'x')
		{
			unsigned long long value = wide > 1 ? va_arg(arguments, unsigned long long) : va_arg(arguments, unsigned);
			add_integer(&t, value, *f == 'x' ? 16 : 10, width);
		}
		else
		{
			char c = *f == 'c' ? (char)va_arg(arguments, int) : *f;
			add(&t, &c, 1);
		}
	}
	if (size > 0)
		text[t.length < size ? t.length : size - 1] = 0;
	return (int)t.length;
}

int snprintf(char* text, size_t size, const char* format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	int length = vsnprintf(text, size, format, arguments);
	va_end(arguments);
	return length;
}

int fprintf(FILE* file, const char* format, ...)
{
	(void)file;
	char text[LOG_BYTES];
	va_list arguments;
	va_start(arguments, format);
	int length = vsnprintf(text, sizeof text, format, arguments);
	va_end(arguments);
	js_log(text);
	return length;
}

// Names of the functions by which clang replaces calls of printf functions: with the letter i if no argument is
// floating-point; with __small_ if no argument is a long double.
int fiprintf(FILE* file, const char* format, ...) __attribute__((alias("fprintf")));
int __small_fprintf(FILE* file, const char* format, ...) __attribute__((alias("fprintf")));
int sniprintf(char* text, size_t size, const char* format, ...) __attribute__((alias("snprintf")));
int __small_snprintf(char* text, size_t size, const char* format, ...) __attribute__((alias("snprintf")));

float strtof(const char* text, char** end)
{
	(void)end;
	return (float)js_parse(text);
}

// Returns null, because a page has no environment.
char* getenv(const char* name)
{
	(void)name;
	return NULL;
}
