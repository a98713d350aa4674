// The picture: a scene in space, or the triangles of one texture, with the maps over it.
import {
  Box3, Color, DoubleSide, type Intersection, Mesh, MeshBasicMaterial, OrthographicCamera, PerspectiveCamera, PlaneGeometry,
  Raycaster, Scene, type ShaderMaterial, type Texture, Vector2, Vector3, Vector4, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

import { onTheme } from "../../report/src/theme";
import type { Loaded, Mapped } from "./load";
import { type Overlay, overlay } from "./overlay";
import type { MapArray } from "./maps";
import { flatMaterial, mapMaterial } from "./shader";
import { tints } from "./tints";

export type Underneath = "as rendered" | "whole" | "none";

export interface Hit {
  of: Mapped;
  triangle: number;
  u: number;
  v: number;
}

const paperColour = (): Color => new Color(getComputedStyle(document.body).backgroundColor);

/** A view: what is drawn, from where, and what a pointer can hit. */
interface View {
  scene: Scene;
  camera: PerspectiveCamera | OrthographicCamera;
  controls: OrbitControls;
  targets: Mesh[];
}

export class Stage {
  readonly canvas = document.createElement("canvas");
  readonly overlays: Overlay[];
  /** Images that primitives with maps have, for views of their own. */
  readonly textures: Texture[];
  private readonly renderer: WebGLRenderer;
  private readonly materials: ShaderMaterial[];
  private readonly bases: MeshBasicMaterial[];
  private readonly planes: MeshBasicMaterial[] = [];
  private readonly looks = new Map<MeshBasicMaterial, { alphaTest: number; transparent: boolean }>();
  private view: View;
  private waits = false;

  constructor(private readonly loaded: Loaded) {
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(window.devicePixelRatio);
    const colours = tints.map(({ word }) => {
      const { r, g, b } = new Color(word).convertLinearToSRGB();
      return new Vector4(r, g, b, 1);
    });
    const byArray = new Map<MapArray, { inSpace: ShaderMaterial; flat: ShaderMaterial }>();
    for (const { arrays } of loaded.mapped) {
      if (byArray.has(arrays)) continue;
      const inSpace = mapMaterial(arrays, colours);
      byArray.set(arrays, { inSpace, flat: flatMaterial(inSpace) });
    }
    this.materials = [...byArray.values()].map(({ inSpace }) => inSpace);
    this.overlays = loaded.mapped.map((mapped) => {
      const { inSpace, flat } = byArray.get(mapped.arrays)!;
      return overlay(mapped, inSpace, flat);
    });
    for (const { of, inSpace } of this.overlays) of.mesh.add(inSpace);
    this.textures = [...new Set(loaded.mapped.map(({ material }) => material.map).filter((map) => map !== null))];
    const bases = new Set<MeshBasicMaterial>();
    loaded.root.traverse((object) => object instanceof Mesh && object.material instanceof MeshBasicMaterial && bases.add(object.material));
    this.bases = [...bases];
    for (const base of this.bases) this.looks.set(base, { alphaTest: base.alphaTest, transparent: base.transparent });
    this.view = this.inSpace();
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    onTheme(() => this.paper());
  }

  private inSpace(): View {
    const scene = new Scene();
    scene.add(this.loaded.root);
    const box = new Box3().setFromObject(this.loaded.root);
    const centre = box.getCenter(new Vector3()), radius = Math.max(box.getSize(new Vector3()).length() / 2, 1e-3);
    const camera = new PerspectiveCamera(35, 1, radius / 100, radius * 100);
    camera.userData["radius"] = radius;
    camera.position.copy(centre).add(new Vector3(0.35, 0.3, 1));
    return this.viewOf(scene, camera, centre, this.overlays.map(({ inSpace }) => inSpace));
  }

  private onTexture(texture: Texture): View {
    const scene = new Scene();
    const over = this.overlays.filter(({ of }) => of.first && of.material.map === texture);
    const flat = over.map(({ onTexture }) => onTexture);
    scene.add(...flat);
    const box = new Box3(new Vector3(0, -1, 0), new Vector3(1, 0, 0));
    for (const mesh of flat) box.expandByObject(mesh);
    // Whole repetitions of the image, at whole UVs.
    const low = box.min.clone().floor(), size = box.max.clone().ceil().sub(low);
    const geometry = new PlaneGeometry(size.x, size.y).translate(low.x + size.x / 2, low.y + size.y / 2, -0.1);
    const position = geometry.getAttribute("position"), uvs = geometry.getAttribute("uv");
    for (let k = 0; k < position.count; ++k) uvs.setXY(k, position.getX(k), -position.getY(k));
    const image = texture.clone();
    image.offset.set(0, 0), image.repeat.set(1, 1), (image.rotation = 0), (image.channel = 0);
    const { alphaTest, transparent } = over[0]!.of.material;
    const material = new MeshBasicMaterial({ map: image, alphaTest, transparent, side: DoubleSide });
    this.looks.set(material, { alphaTest, transparent });
    this.planes.push(material);
    scene.add(new Mesh(geometry, material));
    const camera = new OrthographicCamera(-1, 1, 1, -1, -1, 1);
    const centre = low.clone().addScaledVector(size, 0.5);
    camera.userData["span"] = Math.max(size.x, size.y) * 1.06;
    camera.position.copy(centre).setZ(0.5);
    const view = this.viewOf(scene, camera, centre, flat);
    view.controls.enableRotate = false;
    view.controls.mouseButtons = { LEFT: 2, MIDDLE: 1, RIGHT: 2 };
    view.controls.touches = { ONE: 1, TWO: 2 };
    return view;
  }

  private viewOf(scene: Scene, camera: View["camera"], target: Vector3, targets: Mesh[]): View {
    scene.background = paperColour();
    const controls = new OrbitControls(camera, this.canvas);
    controls.target.copy(target);
    controls.update();
    controls.addEventListener("change", () => this.draw());
    return { scene, camera, controls, targets };
  }

  private paper(): void {
    this.view.scene.background = paperColour();
    this.draw();
  }

  /** The scene, or one texture. */
  show(texture: Texture | null): void {
    this.view.controls.dispose();
    this.view = texture ? this.onTexture(texture) : this.inSpace();
    this.resize();
  }

  uniforms(strength: number, lines: boolean, shown: boolean[]): void {
    for (const { uniforms } of this.materials) {
      uniforms["strength"]!.value = strength;
      uniforms["lines"]!.value = lines ? 1 : 0;
      uniforms["shown"]!.value = new Vector4(...shown.map(Number));
    }
    this.draw();
  }

  underneath(how: Underneath): void {
    for (const material of [...this.bases, ...this.planes]) {
      const was = this.looks.get(material)!;
      material.colorWrite = material.depthWrite = how !== "none";
      material.alphaTest = how === "as rendered" ? was.alphaTest : 0;
      material.transparent = how === "as rendered" && was.transparent;
      material.needsUpdate = true;
    }
    this.draw();
  }

  /** What lies at a place of the canvas, both from 0 to 1. */
  hit(x: number, y: number): Hit | null {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), this.view.camera);
    const hits = ray.intersectObjects(this.view.targets, false) as Intersection<Mesh>[];
    // Flat triangles are all as near: the one that is drawn is the first.
    const order = ({ object, faceIndex }: Intersection<Mesh>): number => this.view.targets.indexOf(object) * 2 ** 32 + (faceIndex ?? 0);
    const [first] = this.view.camera instanceof OrthographicCamera ? hits.sort((a, b) => order(a) - order(b)) : hits;
    const over = this.overlays.find(({ inSpace, onTexture }) => first?.object === inSpace || first?.object === onTexture);
    if (!first || !over || first.faceIndex == null || !first.barycoord) return null;
    return { of: over.of, triangle: first.faceIndex, u: first.barycoord.y, v: first.barycoord.z };
  }

  private resize(): void {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    if (w === 0 || h === 0) return;
    this.renderer.setSize(w, h, false);
    const { camera } = this.view;
    if (camera instanceof PerspectiveCamera) {
      camera.aspect = w / h;
      this.place(camera, Math.min(1, w / h));
    } else {
      const span = camera.userData["span"] as number, x = (span / 2) * Math.max(1, w / h), y = (span / 2) * Math.max(1, h / w);
      Object.assign(camera, { left: -x, right: x, top: y, bottom: -y });
    }
    camera.updateProjectionMatrix();
    this.draw();
  }

  /** Puts a camera so far away that all is seen; once, as users move it. */
  private place(camera: PerspectiveCamera, narrow: number): void {
    const radius = camera.userData["radius"] as number | undefined;
    if (radius === undefined) return;
    delete camera.userData["radius"];
    const half = Math.atan(Math.tan((camera.fov * Math.PI) / 360) * narrow);
    const { target } = this.view.controls;
    camera.position.sub(target).setLength(radius / Math.sin(half)).add(target);
    this.view.controls.update();
  }

  draw(): void {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame(() => {
      this.waits = false;
      this.renderer.render(this.view.scene, this.view.camera);
      this.canvas.dataset["drawn"] = String(Number(this.canvas.dataset["drawn"] ?? 0) + 1);
    });
  }

  dispose(): void {
    this.view.controls.dispose();
    this.renderer.dispose();
  }
}
