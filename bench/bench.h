// SPDX-License-Identifier: MIT
// What is timed and how: a case is a question, a variant one who answers it. Variants of one case are taken in turn in
// one process, so that their ratios hold where the machine is busy with other things.
#ifndef BENCH_BENCH_H
#define BENCH_BENCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

	/// Does the whole of what is timed once.
	typedef void benchRunFcn( void* context );
	/// Makes a variant's context the first time that it is needed. NULL: it cannot be had, and is left out.
	typedef void* benchOpenFcn( const void* argument );
	typedef void benchCloseFcn( void* context );

	/// Names live as long as the list.
	typedef struct benchCase
	{
		const char* name;    // variants of one name stand one after another
		const char* variant; // "sole", "embree" ...
		const char* unit;    // what one item is: "ray", "triangle" ...
		int64_t itemCount;   // in one run
		int64_t size;        // what the plots have along: triangles, characters
		bool counted;        // its instructions are counted as a gate: same work in every run, and little of it
		benchOpenFcn* open;
		const void* argument;
		benchRunFcn* run;     // NULL: nothing is timed, open's context is a double to print
		benchCloseFcn* close; // NULL: nothing to do
	} benchCase;

	typedef struct benchList
	{
		benchCase* cases;
		int32_t count;
		int32_t capacity;
	} benchList;

	/// Ends the program where memory does.
	void* benchAlloc( size_t count, size_t size );
	void benchAdd( benchList* list, benchCase added );
	/// The name "STEM-SIZE", sizes as 10k and 1M, in memory that lives as long as the program.
	const char* benchName( const char* stem, int64_t size );

	/// Nanoseconds since some time.
	double benchNow( void );
	/// Of doubles, for qsort().
	int benchCompare( const void* a, const void* b );

	// Each adds its cases.
	void benchAddGround( benchList* list, int64_t largest );
	void benchAddPlace( benchList* list, int64_t largest );
	void benchAddLegs( benchList* list );
	void benchAddCrowds( benchList* list, int64_t largest );

#ifdef __cplusplus
}
#endif

#endif
