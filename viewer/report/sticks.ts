// SPDX-License-Identifier: MIT
// Lines from joint to joint, for a character without a skin. World space.
import * as THREE from 'three';
import { onTheme } from '../src/page';

export class Sticks
{
	readonly lines = new THREE.LineSegments( new THREE.BufferGeometry(), new THREE.LineBasicMaterial() );
	private readonly pairs: [ THREE.Object3D, THREE.Object3D ][] = [];

	/// @param pelvis what all that is seen hangs from
	constructor( pelvis: THREE.Object3D, layer: number )
	{
		pelvis.traverse( ( node ) => node.children.forEach( ( child ) => this.pairs.push( [ node, child ] ) ) );
		this.lines.geometry.setAttribute( 'position', new THREE.BufferAttribute( new Float32Array( 6 * this.pairs.length ), 3 ) );
		this.lines.frustumCulled = false;
		this.lines.layers.set( layer );
		onTheme( ( theme ) => this.lines.material.color.set( theme === 'dark' ? 0xf2d28a : 0x7a4a00 ) );
	}

	/// To where the joints are now.
	update(): void
	{
		const place = this.lines.geometry.getAttribute( 'position' );
		const at = new THREE.Vector3();
		this.pairs.flat().forEach( ( node, index ) =>
		{
			at.setFromMatrixPosition( node.matrixWorld );
			place.setXYZ( index, at.x, at.y, at.z );
		} );
		place.needsUpdate = true;
	}
}
