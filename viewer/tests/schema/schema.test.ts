// The JSON schema that `washtub reference --schema` prints, against a schema validator: every case
// of the project is valid, wrong ones are not.
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import Ajv from 'ajv-draft-04';
import { parse, type TomlTable } from 'smol-toml';
import { describe, expect, it } from 'vitest';

const program = process.env.WASHTUB_PROGRAM!;
const root = fileURLToPath(new URL('../../..', import.meta.url));
const schema = JSON.parse(execFileSync(program, ['reference', '--schema'], { encoding: 'utf8' }));
const validate = new Ajv({ allErrors: true }).compile(schema);

/** Case files below a folder; an expected.toml is none. */
function cases(folder: string): string[] {
  return readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.toml') && !name.endsWith('expected.toml'))
    .map((name) => join(folder, name));
}

const read = (file: string): TomlTable => parse(readFileSync(join(root, file), 'utf8'));

/** Places and messages of the errors in a case. */
function faults(text: string): string {
  validate(parse(text));
  return (validate.errors ?? [])
    .map((e) => `${e.instancePath} ${e.message} ${JSON.stringify(e.params)}`)
    .join('\n');
}

const small = `dimension = 2
[fluid]
viscosity = "1 Pa s"
[domain]
size = ["1 m", "1 m"]
cells = 32
[time]
end = "1 s"
`;

describe('the schema of case files', () => {
  it.each([...cases('cases'), ...cases('verification')])('takes %s', (file) => {
    expect(validate(read(file)), JSON.stringify(validate.errors, null, 1)).toBe(true);
  });

  it('finds all of them', () => {
    expect(cases('cases').length).toBeGreaterThanOrEqual(3);
    expect(cases('verification').length).toBeGreaterThanOrEqual(15);
  });

  it('takes a resolved case and shapes made of others', () => {
    expect(faults(small)).toBe('');
    expect(
      faults(`${small}[[solid]]
name = "post"
drive = { kind = "table", times = ["0 s", "1 s"], speeds = ["0 rpm", "+60 rpm"] }
[solid.shape]
kind = "difference"
parts = [{ kind = "sphere", radius = ".2 m" }, { kind = "union", parts = [
  { kind = "box", lower = ["0 m", "0 m"], upper = ["1e-1 m", "10cm"], angle = "4 deg" }] }]
`),
    ).toBe('');
  });

  it.each([
    [
      'an unknown key',
      `${small}cfk = 0.3\n`,
      '/time must NOT have additional properties {"additionalProperty":"cfk"}',
    ],
    ['an unknown table', `${small}[solvers]\n`, ' must NOT have additional properties'],
    [
      'a missing key',
      small.replace('viscosity', 'density'),
      "/fluid must have required property 'viscosity'",
    ],
    [
      'a missing table',
      small.replace(/\[fluid\]\n.*\n/, ''),
      " must have required property 'fluid'",
    ],
    ['a number without unit', small.replace('"1 s"', '1.0'), '/time/end must be string'],
    ['a text without unit', small.replace('"1 s"', '"1e5"'), '/time/end must match pattern'],
    [
      'a wrong name',
      `${small}[coupling]\nkernel = "gauss"\n`,
      '/coupling/kernel must be equal to one of the allowed values',
    ],
    ['a number out of range', `${small}cfl = 0.6\n`, '/time/cfl must be <= 0.5'],
    ['an excluded bound', `${small}cfl = 0.0\n`, '/time/cfl must be > 0'],
    ['a count that is none', small.replace('32', '32.5'), '/domain/cells must be integer'],
    [
      'a list too long',
      small.replace('"1 m"]', '"1 m", "1 m", "1 m"]'),
      '/domain/size must NOT have more than 3 items',
    ],
    [
      'an unknown kind',
      `${small}[[solid]]\nname = "a"\nshape = { kind = "cone" }\n`,
      '/solid/0/shape',
    ],
    [
      'a key of another kind',
      `${small}[[solid]]\nname = "a"\nshape = { kind = "sphere", radius = "1 m" }\ndrive = { kind = "constant", peak = "1 rpm" }\n`,
      '/solid/0/drive',
    ],
  ])('refuses %s', (_, text, fault) => {
    expect(faults(text)).toContain(fault);
  });

  it('says what a key means and what it is without it', () => {
    const { properties } = schema.properties.fluid;
    expect(properties.density).toMatchObject({
      default: '1000 kg/m^3',
      description: 'density, rho: density [kg/m^3], > 0 kg/m^3',
    });
    expect(schema.properties.washer.properties.stroke.default.kind).toBe('sinusoid');
    expect(
      schema.properties.washer.properties.agitator.properties.rim_radius.description,
    ).toContain('default: 0.70 r');
  });
});
