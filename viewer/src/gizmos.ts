// SPDX-License-Identifier: MIT
// Draws what the library shows of a frame: lines, arrows, circles, spheres and texts, over everything else. The
// geometry is made anew each frame in buffers that are kept.
import * as THREE from 'three';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { Shape } from './library';

const MOST_LINES = 6000;
const MOST_BALLS = 600;
const CIRCLE_PIECES = 40;
const HEAD = 0.22; // of an arrow's length
const BIG_BALL = 0.03; // m: spheres larger than this are rings

const a = new THREE.Vector3();
const b = new THREE.Vector3();
const side = new THREE.Vector3();
const other = new THREE.Vector3();

/// A unit vector orthogonal to another, into `side`, and the third into `other`.
function findSides( axis: THREE.Vector3 ): void
{
	side.set( Math.abs( axis.x ) < 0.7 ? 1 : 0, Math.abs( axis.x ) < 0.7 ? 0 : 1, 0 );
	side.addScaledVector( axis, -side.dot( axis ) ).normalize();
	other.crossVectors( axis, side );
}

export class Gizmos
{
	readonly group = new THREE.Group();
	private readonly lines: LineSegments2;
	private readonly balls: THREE.InstancedMesh;
	private readonly places = new Float32Array( MOST_LINES * 6 );
	private readonly colors = new Float32Array( MOST_LINES * 6 );
	private readonly color = new THREE.Color();
	private lineCount = 0;
	private ballCount = 0;

	/// @param layer of the view in which they are seen
	constructor( layer: number )
	{
		const geometry = new LineSegmentsGeometry();
		geometry.setPositions( this.places );
		geometry.setColors( this.colors );
		const material = new LineMaterial( { vertexColors: true, linewidth: 2, depthTest: false, transparent: true, fog: false } );
		this.lines = new LineSegments2( geometry, material );
		const ball = new THREE.MeshBasicMaterial( { depthTest: false, transparent: true, fog: false } );
		this.balls = new THREE.InstancedMesh( new THREE.IcosahedronGeometry( 1, 1 ), ball, MOST_BALLS );
		this.balls.setColorAt( 0, this.color );
		for ( const [ order, object ] of [ this.lines, this.balls ].entries() )
		{
			object.frustumCulled = false;
			object.renderOrder = 10 + order;
			object.layers.set( layer );
			this.group.add( object );
		}
	}

	private addLine( from: THREE.Vector3, to: THREE.Vector3 ): void
	{
		if ( this.lineCount < MOST_LINES )
		{
			const at = 6 * this.lineCount++;
			from.toArray( this.places, at );
			to.toArray( this.places, at + 3 );
			this.color.toArray( this.colors, at );
			this.color.toArray( this.colors, at + 3 );
		}
	}

	private addArrow( from: THREE.Vector3, to: THREE.Vector3 ): void
	{
		this.addLine( from, to );
		const axis = to.clone().sub( from );
		const length = axis.length();
		findSides( axis.divideScalar( Math.max( length, 1e-9 ) ) );
		const neck = to.clone().addScaledVector( axis, -HEAD * length );
		for ( const sign of [ -1, 1 ] )
		{
			this.addLine( neck.clone().addScaledVector( side, 0.4 * sign * HEAD * length ), to );
			this.addLine( neck.clone().addScaledVector( other, 0.4 * sign * HEAD * length ), to );
		}
	}

	private addCircle( center: THREE.Vector3, normal: THREE.Vector3, radius: number ): void
	{
		findSides( normal );
		const e = side.clone();
		const f = other.clone();
		const at = ( k: number, to: THREE.Vector3 ): THREE.Vector3 =>
		{
			const angle = 2 * Math.PI * k / CIRCLE_PIECES;
			return to.copy( center ).addScaledVector( e, radius * Math.cos( angle ) ).addScaledVector( f, radius * Math.sin( angle ) );
		};
		for ( let k = 0; k < CIRCLE_PIECES; ++k )
		{
			this.addLine( at( k, new THREE.Vector3() ), at( k + 1, new THREE.Vector3() ) );
		}
	}

	private addBall( center: THREE.Vector3, radius: number ): void
	{
		if ( radius > BIG_BALL )
		{
			[ new THREE.Vector3( 1, 0, 0 ), new THREE.Vector3( 0, 1, 0 ), new THREE.Vector3( 0, 0, 1 ) ].forEach(
				( axis ) => this.addCircle( center, axis, radius ) );
		}
		else if ( this.ballCount < MOST_BALLS )
		{
			const matrix = new THREE.Matrix4().makeScale( radius, radius, radius ).setPosition( center );
			this.balls.setColorAt( this.ballCount, this.color );
			this.balls.setMatrixAt( this.ballCount++, matrix );
		}
	}

	/// Everything that is shown now, instead of what was.
	/// @return the texts: who has them decides where on the page they go
	draw( shapes: readonly Shape[] ): Shape[]
	{
		this.lineCount = 0;
		this.ballCount = 0;
		const texts: Shape[] = [];
		for ( const shape of shapes )
		{
			this.color.setHex( shape.color );
			a.fromArray( shape.a );
			b.fromArray( shape.b );
			switch ( shape.kind )
			{
			case 'line':
				this.addLine( a, b );
				break;
			case 'arrow':
				this.addArrow( a, b );
				break;
			case 'circle':
				this.addCircle( a.clone(), b.clone(), shape.radius );
				break;
			case 'sphere':
				this.addBall( a.clone(), shape.radius );
				break;
			case 'text':
				texts.push( shape );
				break;
			}
		}
		this.upload();
		return texts;
	}

	private upload(): void
	{
		const geometry = this.lines.geometry;
		geometry.instanceCount = this.lineCount;
		// The two attributes of an end share one buffer.
		( geometry.getAttribute( 'instanceStart' ) as THREE.InterleavedBufferAttribute ).data.needsUpdate = true;
		( geometry.getAttribute( 'instanceColorStart' ) as THREE.InterleavedBufferAttribute ).data.needsUpdate = true;
		this.lines.visible = this.lineCount > 0;
		this.balls.count = this.ballCount;
		this.balls.instanceMatrix.needsUpdate = true;
		this.balls.instanceColor!.needsUpdate = true;
	}
}
