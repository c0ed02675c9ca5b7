import * as THREE from 'three';

/**
 * Matt, seen from both sides; the far side of a piece and what is seen edge-on are darker, so
 * that folds can be read. `glow`, from 0 to 1: part of the colour that no shadow takes away, for
 * colours that stand for values.
 */
export function clothMaterial(): { material: THREE.Material; glow: { value: number } } {
  const material = new THREE.MeshStandardMaterial({
    vertexColors: true,
    side: THREE.DoubleSide,
    roughness: 0.78,
    metalness: 0,
  });
  const glow = { value: 0 };
  material.onBeforeCompile = (shader) => {
    shader.uniforms.glow = glow;
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nuniform float glow;')
      .replace(
        '#include <normal_fragment_maps>',
        `#include <normal_fragment_maps>
        float facing = abs(dot(normal, normalize(vViewPosition)));
        diffuseColor.rgb *= mix(0.55, 1.0, smoothstep(0.0, 0.55, facing));
        diffuseColor.rgb *= gl_FrontFacing ? 1.0 : mix(0.8, 1.0, glow);
        totalEmissiveRadiance += 0.6 * glow * diffuseColor.rgb;`,
      );
  };
  return { material, glow };
}
