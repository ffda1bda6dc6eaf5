// SPDX-License-Identifier: MIT
// What is seen: renderer, lights, camera and the one or two views beside each other. World space, metres, +Y up.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { onTheme, type Theme } from './page';

/// Things of the first view, the second, or both (0).
export const LAYER_BOTH = 0;
export const LAYER_FIRST = 1;
export const LAYER_SECOND = 2;

const VIEW_ANGLE = 32;
// Where the camera begins, in leg lengths from what it looks at: from the side, a little ahead, so that both feet and
// what they stand on are seen.
const CAMERA_PLACE = new THREE.Vector3( -3.3, 0.75, 1.5 );
const FOLLOW_TIME = 0.12; // s
const FAR = 400;

const colors: Record<Theme, { back: number; fog: number; sky: number; floor: number; sun: number }> = {
	light: { back: 0xdfe4ea, fog: 0xdfe4ea, sky: 0xffffff, floor: 0xb8bcc4, sun: 2.1 },
	dark: { back: 0x20252d, fog: 0x20252d, sky: 0xc4d2e6, floor: 0x3a3f48, sun: 1.7 },
};

export class Stage
{
	readonly scene = new THREE.Scene();
	readonly camera = new THREE.PerspectiveCamera( VIEW_ANGLE, 1, 0.02, FAR );
	readonly controls: OrbitControls;
	readonly renderer: THREE.WebGLRenderer;
	/// Layers of the views, left to right.
	views: number[] = [ LAYER_FIRST ];
	private readonly sun = new THREE.DirectionalLight( 0xffffff, 2 );
	private readonly sky = new THREE.HemisphereLight( 0xffffff, 0x888888, 1.5 );
	private readonly target = new THREE.Vector3();
	private readonly canvas: HTMLCanvasElement;

	/// @param plain without what makes pictures differ or slow: for tests
	constructor( canvas: HTMLCanvasElement, plain: boolean )
	{
		this.canvas = canvas;
		this.renderer = new THREE.WebGLRenderer( { canvas, antialias: plain === false, preserveDrawingBuffer: plain } );
		this.renderer.setPixelRatio( plain ? 1 : Math.min( devicePixelRatio, 2 ) );
		this.renderer.shadowMap.enabled = plain === false;
		this.renderer.shadowMap.type = THREE.PCFShadowMap;
		this.renderer.autoClear = false;
		this.controls = new OrbitControls( this.camera, canvas );
		this.controls.enableDamping = false;
		this.controls.minDistance = 0.2;
		this.controls.maxDistance = 80;
		this.sun.castShadow = true;
		this.sun.shadow.mapSize.set( 2048, 2048 );
		this.sun.shadow.bias = -0.0004;
		this.sun.shadow.normalBias = 0.01;
		this.scene.add( this.sun, this.sun.target, this.sky );
		onTheme( ( theme ) => this.paint( theme ) );
	}

	private paint( theme: Theme ): void
	{
		const c = colors[ theme ];
		this.scene.background = new THREE.Color( c.back );
		this.scene.fog = new THREE.Fog( c.fog, 12, 60 );
		this.sky.color.set( c.sky );
		this.sky.groundColor.set( c.floor );
		this.sun.intensity = c.sun;
	}

	/// Looks at a place as for the first time.
	frame( target: THREE.Vector3, legLength: number, heading: number ): void
	{
		this.target.copy( target );
		this.controls.target.copy( target );
		const away = CAMERA_PLACE.clone().multiplyScalar( legLength ).applyAxisAngle( new THREE.Vector3( 0, 1, 0 ), heading );
		// A narrow picture is seen from further off.
		away.multiplyScalar( Math.max( 1, 0.62 / Math.max( this.camera.aspect, 0.3 ) ) );
		this.camera.position.copy( target ).add( away );
		const span = 3.5 * legLength;
		const shadow = this.sun.shadow.camera;
		Object.assign( shadow, { left: -span, right: span, top: span, bottom: -span, near: 0.1, far: 12 * legLength } );
		shadow.updateProjectionMatrix();
		this.controls.update();
	}

	/// Goes along with a place, a little late: a body that jumps is seen to jump.
	follow( place: THREE.Vector3, timeStep: number, jumped: boolean ): void
	{
		const share = jumped ? 1 : 1 - Math.exp( -timeStep / FOLLOW_TIME );
		const step = place.clone().sub( this.target ).multiplyScalar( share );
		this.target.add( step );
		this.controls.target.add( step );
		this.camera.position.add( step );
	}

	private lightUp(): void
	{
		this.sun.target.position.copy( this.target );
		const reach = this.sun.shadow.camera.far * 0.5;
		this.sun.position.copy( this.target ).add( new THREE.Vector3( -0.45, 0.85, 0.3 ).multiplyScalar( reach ) );
	}

	/// The size of one view in the page's pixels.
	get viewSize(): THREE.Vector2
	{
		return new THREE.Vector2( this.canvas.clientWidth / this.views.length, this.canvas.clientHeight );
	}

	/// As large as the canvas is on the page now.
	resize(): void
	{
		const width = this.canvas.clientWidth;
		const height = this.canvas.clientHeight;
		const size = this.renderer.getSize( new THREE.Vector2() );
		if ( size.x !== width || size.y !== height )
		{
			this.renderer.setSize( width, height, false );
		}
		const view = this.viewSize;
		const aspect = view.x / Math.max( view.y, 1 );
		if ( Math.abs( aspect - this.camera.aspect ) > 1e-6 )
		{
			this.camera.aspect = aspect;
			this.camera.updateProjectionMatrix();
		}
	}

	render(): void
	{
		this.resize();
		this.controls.update();
		this.lightUp();
		const view = this.viewSize;
		this.renderer.setScissorTest( this.views.length > 1 );
		this.views.forEach( ( layer, index ) =>
		{
			this.renderer.setViewport( index * view.x, 0, view.x, view.y );
			this.renderer.setScissor( index * view.x, 0, view.x - ( index + 1 < this.views.length ? 1 : 0 ), view.y );
			this.camera.layers.set( LAYER_BOTH );
			this.camera.layers.enable( layer );
			this.renderer.clear();
			this.renderer.render( this.scene, this.camera );
		} );
		this.camera.layers.enableAll();
	}

	/// Where a place is on the page, seen in a view. NULL: not in the picture.
	project( place: THREE.Vector3, view: number ): THREE.Vector2 | null
	{
		const p = place.clone().project( this.camera );
		const size = this.viewSize;
		const inside = Math.abs( p.x ) < 1 && Math.abs( p.y ) < 1 && p.z < 1;
		return inside ? new THREE.Vector2( ( view + 0.5 + 0.5 * p.x ) * size.x, ( 0.5 - 0.5 * p.y ) * size.y ) : null;
	}

	/// The ray under a place of the page.
	pick( x: number, y: number ): THREE.Raycaster
	{
		const box = this.canvas.getBoundingClientRect();
		const size = this.viewSize;
		const local = ( ( x - box.left ) % size.x ) / size.x;
		const caster = new THREE.Raycaster();
		caster.layers.enableAll();
		caster.setFromCamera( new THREE.Vector2( 2 * local - 1, 1 - 2 * ( y - box.top ) / size.y ), this.camera );
		return caster;
	}
}
