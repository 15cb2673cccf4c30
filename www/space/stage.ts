/** Draws surfaces and lines into a canvas by WebGL; knows neither solver nor session. */

import { Camera, Geometry, Mesh, Program, Renderer, Transform } from "ogl";
import { FIELD_OF_VIEW, type Pose, sight } from "./camera";
import type { Segments } from "./slice";

/** A surface before and after the deformation; x y z and red green blue a vertex. */
export type Skin = {
  readonly from: Float32Array;
  readonly to: Float32Array;
  readonly fromNormals: Float32Array;
  readonly toNormals: Float32Array;
  readonly colours: Float32Array;
  /** Where in the reference's box each vertex has its lines; none without. x y z a vertex. */
  readonly places: Float32Array | null;
  readonly indices: Uint32Array;
  /** Below 1 it is seen through. */
  readonly opacity: number;
};

export type Lines = Segments & { readonly colour: readonly [number, number, number] };

export type Scene = {
  readonly skins: readonly Skin[];
  readonly lines: readonly Lines[];
  /** What of the reference's box is cut away: where the axis is beyond the part. */
  readonly cut: { readonly axis: number; readonly part: number } | null;
};

export type Light = { readonly paper: readonly [number, number, number] };

const SKIN_VERTEX = `#version 300 es
in vec3 position, origin, normal, originNormal, colour, place;
uniform mat4 viewMatrix, projectionMatrix;
uniform float morph;
out vec3 vNormal, vColour, vOrigin, vPlace;
void main() {
  vOrigin = origin;
  vColour = colour;
  vPlace = place;
  vNormal = mat3(viewMatrix) * mix(originNormal, normal, morph);
  gl_Position = projectionMatrix * viewMatrix * vec4(mix(origin, position, morph), 1.0);
}`;

/** Lines a box length, in each direction. */
const LINES = 14;

// Light comes from the viewer's left shoulder, so that shapes read the same however they are turned.
const SKIN_FRAGMENT = `#version 300 es
precision highp float;
uniform vec4 beyond;
uniform float opacity, lined;
in vec3 vNormal, vColour, vOrigin, vPlace;
out vec4 painted;
void main() {
  if (dot(beyond.xyz, vOrigin) > beyond.w) discard;
  vec3 at = vPlace * ${LINES.toFixed(1)} + 0.5;
  vec3 wide = max(fwidth(at), vec3(1e-5));
  vec3 near = 1.0 - smoothstep(0.5 * wide, 1.5 * wide, 0.5 - abs(fract(at) - 0.5));
  float ink = lined * 0.38 * max(near.x, max(near.y, near.z));
  vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal);
  float light = 0.6 + 0.45 * max(0.0, dot(n, normalize(vec3(-0.35, 0.45, 0.82))));
  float inner = gl_FrontFacing ? 1.0 : 0.8;
  painted = vec4(vColour * (1.0 - ink) * min(1.0, light) * inner * opacity, opacity);
}`;

const LINE_VERTEX = `#version 300 es
in vec3 position, origin;
uniform mat4 viewMatrix, projectionMatrix;
uniform float morph;
void main() {
  gl_Position = projectionMatrix * viewMatrix * vec4(mix(origin, position, morph), 1.0);
  // In front of the surface that they lie on.
  gl_Position.z -= 0.0015 * gl_Position.w;
}`;

const LINE_FRAGMENT = `#version 300 es
precision mediump float;
uniform vec3 tint;
out vec4 painted;
void main() { painted = vec4(tint, 1.0); }`;

const KEEP_ALL = [0, 0, 0, 1];

export class Stage {
  private readonly renderer: Renderer;
  private readonly camera: Camera;
  private readonly root = new Transform();
  private meshes: Mesh[] = [];

  /** Throws where the browser gives no WebGL: the sentence is the caller's. */
  constructor(readonly canvas: HTMLCanvasElement) {
    const options = { alpha: true, antialias: true, premultipliedAlpha: true, preserveDrawingBuffer: true };
    const context = canvas.getContext("webgl2", { ...options, depth: true });
    if (!context) throw new Error("no WebGL");
    this.renderer = new Renderer({ canvas, ...options, webgl: 2 });
    this.camera = new Camera(this.renderer.gl, { fov: FIELD_OF_VIEW, near: 0.05, far: 20 });
  }

  show({ skins, lines, cut }: Scene): void {
    this.clear();
    const { gl } = this.renderer;
    const beyond = cut ? [...[0, 1, 2].map((axis) => (axis === cut.axis ? 1 : 0)), cut.part] : KEEP_ALL;
    for (const skin of skins) {
      const isClear = skin.opacity < 1;
      const geometry = new Geometry(gl, {
        position: { size: 3, data: skin.to },
        origin: { size: 3, data: skin.from },
        normal: { size: 3, data: skin.toNormals },
        originNormal: { size: 3, data: skin.fromNormals },
        colour: { size: 3, data: skin.colours },
        place: { size: 3, data: skin.places ?? skin.from },
        index: { data: skin.indices },
      });
      const program = new Program(gl, {
        vertex: SKIN_VERTEX,
        fragment: SKIN_FRAGMENT,
        cullFace: isClear ? gl.BACK : false,
        transparent: isClear,
        depthWrite: !isClear,
        uniforms: {
          morph: { value: 1 },
          beyond: { value: beyond },
          opacity: { value: skin.opacity },
          lined: { value: skin.places ? 1 : 0 },
        },
      });
      this.add(new Mesh(gl, { geometry, program }));
    }
    for (const { from, to, colour } of lines) {
      if (from.length === 0) continue;
      const geometry = new Geometry(gl, { position: { size: 3, data: to }, origin: { size: 3, data: from } });
      const program = new Program(gl, {
        vertex: LINE_VERTEX,
        fragment: LINE_FRAGMENT,
        cullFace: false,
        uniforms: { morph: { value: 1 }, tint: { value: colour } },
      });
      this.add(new Mesh(gl, { geometry, program, mode: gl.LINES }));
    }
  }

  draw(pose: Pose, morph: number): void {
    const { clientWidth, clientHeight } = this.canvas;
    this.paint(pose, morph, clientWidth || 1, clientHeight || 1, devicePixelRatio);
  }

  /** At another size, for films; on a canvas that is not on the page. */
  still(pose: Pose, morph: number, side: number): void {
    this.paint(pose, morph, side, side, 1);
  }

  /** At another size, for print; what is on the page is drawn anew afterwards. */
  async picture(pose: Pose, morph: number, side: number): Promise<Blob> {
    this.paint(pose, morph, side, side, 1);
    const blob = await new Promise<Blob | null>((resolve) => this.canvas.toBlob(resolve, "image/png"));
    this.canvas.style.width = "";
    this.canvas.style.height = "";
    this.draw(pose, morph);
    if (!blob) throw new Error("The browser could not make the picture; it may be short of memory.");
    return blob;
  }

  dispose(): void {
    this.clear();
    // Browsers allow some sixteen contexts at a time, and forget them late.
    this.renderer.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  private paint(pose: Pose, morph: number, width: number, height: number, ratio: number): void {
    this.renderer.dpr = ratio;
    this.renderer.setSize(width, height);
    // The style sheet says how large it is seen.
    this.canvas.style.removeProperty("width");
    this.canvas.style.removeProperty("height");
    const { eye, aim } = sight(pose);
    this.camera.perspective({ aspect: width / height });
    this.camera.position.set(...eye);
    this.camera.lookAt([...aim]);
    for (const { program } of this.meshes) program.uniforms.morph.value = morph;
    this.renderer.render({ scene: this.root, camera: this.camera, frustumCull: false });
  }

  private add(mesh: Mesh): void {
    mesh.setParent(this.root);
    this.meshes.push(mesh);
  }

  private clear(): void {
    for (const mesh of this.meshes) {
      mesh.setParent(null);
      mesh.geometry.remove();
      mesh.program.remove();
    }
    this.meshes = [];
  }
}
