// SPDX-License-Identifier: MIT
// Undo and redo of a value that is replaced as a whole.

export class History<T>
{
	private past: T[] = [];
	private future: T[] = [];

	constructor( private current: T, private readonly same: ( a: T, b: T ) => boolean )
	{
	}

	/// A new value that the user chose.
	push( value: T ): void
	{
		if ( this.same( this.current, value ) === false )
		{
			this.past.push( this.current );
			this.current = value;
			this.future = [];
		}
	}

	get canUndo(): boolean
	{
		return this.past.length > 0;
	}

	get canRedo(): boolean
	{
		return this.future.length > 0;
	}

	undo(): T
	{
		return this.current = this.move( this.past, this.future );
	}

	redo(): T
	{
		return this.current = this.move( this.future, this.past );
	}

	private move( from: T[], to: T[] ): T
	{
		const value = from.pop();
		if ( value === undefined )
		{
			return this.current;
		}
		to.push( this.current );
		return value;
	}
}
