// SPDX-License-Identifier: MIT
// Messages for people, formatted as the C library would: the module has none of its own for this, which would be a
// tenth of its size and want to be handed a file system. Understands what the library's messages use: %d %u %zu %s %f
// %g with a precision, and %%. Numbers are right to nine digits. For the same reason strncpy() is here.
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef struct soleText
{
	char* text;
	size_t capacity;
	size_t count; // that there would be with room
} soleText;

static void solePutChar( soleText* out, char c )
{
	if ( out->count + 1 < out->capacity )
	{
		out->text[out->count] = c;
	}
	out->count += 1;
}

static void solePutString( soleText* out, const char* text, int precision )
{
	for ( int i = 0; text[i] != 0 && ( precision < 0 || i < precision ); ++i )
	{
		solePutChar( out, text[i] );
	}
}

/// @param least digits, with zeros before them
static void solePutUnsigned( soleText* out, uint64_t number, int least )
{
	char digits[24];
	int count = 0;
	for ( ; number > 0 || count < least; number /= 10 )
	{
		digits[count++] = (char)( '0' + number % 10 );
	}
	while ( count > 0 )
	{
		solePutChar( out, digits[--count] );
	}
}

static double solePowerOfTen( int exponent )
{
	double power = 1.0;
	for ( int i = 0; i < exponent; ++i )
	{
		power *= 10.0;
	}
	return power;
}

/// x in [0, 1e15)
static void solePutFixed( soleText* out, double x, int decimals, bool trim )
{
	uint64_t unit = (uint64_t)solePowerOfTen( decimals );
	uint64_t scaled = (uint64_t)( x * (double)unit + 0.5 );
	uint64_t rest = scaled % unit;
	solePutUnsigned( out, scaled / unit, 1 );
	while ( trim && decimals > 0 && rest % 10 == 0 )
	{
		rest /= 10;
		--decimals;
	}
	if ( decimals > 0 )
	{
		solePutChar( out, '.' );
		solePutUnsigned( out, rest, decimals );
	}
}

/// x > 0
static void solePutGeneral( soleText* out, double x, int digits )
{
	digits = digits == 0 ? 1 : digits;
	int exponent = 0;
	double mantissa = x;
	for ( ; mantissa >= 10.0; ++exponent )
	{
		mantissa /= 10.0;
	}
	for ( ; mantissa < 1.0; --exponent )
	{
		mantissa *= 10.0;
	}
	double unit = solePowerOfTen( digits - 1 );
	if ( (double)(uint64_t)( mantissa * unit + 0.5 ) >= 10.0 * unit )
	{
		mantissa = 1.0; // 9.9996 is 10.00
		++exponent;
	}
	if ( exponent >= -4 && exponent < digits )
	{
		solePutFixed( out, x, digits - 1 - exponent, true );
		return;
	}
	solePutFixed( out, mantissa, digits - 1, true );
	solePutString( out, exponent < 0 ? "e-" : "e+", -1 );
	solePutUnsigned( out, (uint64_t)( exponent < 0 ? -exponent : exponent ), 2 );
}

static void solePutNumber( soleText* out, double x, char kind, int precision )
{
	if ( !( x - x == 0.0 ) )
	{
		solePutString( out, x != x ? "nan" : ( x > 0.0 ? "inf" : "-inf" ), -1 );
		return;
	}
	if ( x < 0.0 )
	{
		solePutChar( out, '-' );
		x = -x;
	}
	precision = precision < 0 ? 6 : ( precision > 9 ? 9 : precision );
	if ( kind == 'f' && x < 1e9 )
	{
		solePutFixed( out, x, precision, false );
	}
	else if ( x == 0.0 )
	{
		solePutChar( out, '0' );
	}
	else
	{
		solePutGeneral( out, x, precision );
	}
}

static void solePutInteger( soleText* out, int number )
{
	if ( number < 0 )
	{
		solePutChar( out, '-' );
	}
	solePutUnsigned( out, (uint64_t)( number < 0 ? -(int64_t)number : number ), 1 );
}

int vsnprintf( char* text, size_t capacity, const char* format, va_list arguments )
{
	soleText out = { text, capacity, 0 };
	for ( const char* at = format; *at != 0; ++at )
	{
		if ( *at != '%' )
		{
			solePutChar( &out, *at );
			continue;
		}
		int precision = -1;
		++at;
		if ( *at == '.' )
		{
			precision = 0;
			for ( ++at; *at >= '0' && *at <= '9'; ++at )
			{
				precision = 10 * precision + ( *at - '0' );
			}
		}
		at += *at == 'z' ? 1 : 0;
		switch ( *at )
		{
		case 'd':
			solePutInteger( &out, va_arg( arguments, int ) );
			break;
		case 'u': // size_t has its size here
			solePutUnsigned( &out, va_arg( arguments, unsigned ), 1 );
			break;
		case 's':
			solePutString( &out, va_arg( arguments, const char* ), precision );
			break;
		case 'f':
		case 'g':
			solePutNumber( &out, va_arg( arguments, double ), *at, precision );
			break;
		default:
			solePutChar( &out, *at );
			break;
		}
	}
	if ( capacity > 0 )
	{
		text[out.count < capacity ? out.count : capacity - 1] = 0;
	}
	return (int)out.count;
}

int snprintf( char* text, size_t capacity, const char* format, ... )
{
	va_list arguments;
	va_start( arguments, format );
	int count = vsnprintf( text, capacity, format, arguments );
	va_end( arguments );
	return count;
}

char* strncpy( char* to, const char* from, size_t count )
{
	bool ended = false;
	for ( size_t i = 0; i < count; ++i )
	{
		ended = ended || from[i] == 0;
		to[i] = ended ? 0 : from[i];
	}
	return to;
}
