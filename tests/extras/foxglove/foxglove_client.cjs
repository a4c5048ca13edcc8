// Foxglove's own client library and serializers, as the opposite end of a machine with a turtlesim: says what it saw as JSON.
'use strict';
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const { parse } = require('@foxglove/rosmsg');
const { MessageReader, MessageWriter } = require('@foxglove/rosmsg2-serialization');
const { WebSocket } = require('ws');

const [, , url, protocol] = process.argv;
const client = new FoxgloveClient({ ws: new WebSocket(url, [protocol]) });
const seen = { channels: {}, services: {}, parameters: {}, poses: [], answers: [], failures: [], graph: {} };
const TWIST = 'geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n===\n'
  + 'MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z';
const PARAMETER = '/turtlesim.background_r';
let waiting = [];

/* Wait until something is so: it is asked after each event. */
const until = ready => new Promise(done => { waiting.push([ready, done]); tell(); });
function tell() {
  const [now, later] = [[], []];
  for (const one of waiting) (one[0]() ? now : later).push(one);
  waiting = later;
  for (const [, done] of now) done();
}
const on = (name, take) => client.on(name, event => { take(event); tell(); });
const definition = text => parse(text, { ros2: true });
const view = data => new DataView(data.buffer, data.byteOffset, data.byteLength);

on('error', error => { throw error; });
on('serverInfo', info => { seen.info = info; });
on('advertise', list => list.forEach(one => { seen.channels[one.topic] = one; }));
on('advertiseServices', list => list.forEach(one => { seen.services[one.name] = one; }));
on('parameterValues', event => event.parameters.forEach(one => { seen.parameters[one.name] = one.value; }));
on('time', time => { seen.time = time.timestamp; });
on('message', event => { seen.poses.push(seen.reader.readMessage(event.data)); });
on('connectionGraphUpdate', graph => { graph.publishedTopics.forEach(one => { seen.graph[one.name] = one.publisherIds; }); });
on('serviceCallResponse', event => { seen.answers.push(event); });
on('serviceCallFailure', event => { seen.failures.push(event.message); });

async function main() {
  const told = {};
  await until(() => seen.info && seen.time && seen.channels['/turtle1/pose'] && seen.services['/spawn']);
  told.capabilities = seen.info.capabilities.sort();
  const pose = seen.channels['/turtle1/pose'];
  seen.reader = new MessageReader(definition(pose.schema));
  const subscription = client.subscribe(pose.id);
  await until(() => seen.poses.length);
  client.subscribeConnectionGraph();
  await until(() => seen.graph['/turtle1/pose']);
  told.publishers = seen.graph['/turtle1/pose'];
  const twist = client.advertise({ topic: '/turtle1/cmd_vel', encoding: 'cdr', schemaName: 'geometry_msgs/msg/Twist' });
  const still = { x: 0, y: 0, z: 0 }, from = seen.poses.at(-1).x;
  client.sendMessage(twist, new MessageWriter(definition(TWIST)).writeMessage({ linear: { ...still, x: 1 }, angular: still }));
  await until(() => seen.poses.at(-1).x > from + 0.5);
  client.unadvertise(twist);
  client.getParameters([PARAMETER], 'get');
  await until(() => PARAMETER in seen.parameters);
  told.before = seen.parameters[PARAMETER];
  client.subscribeParameterUpdates([PARAMETER]);
  client.setParameters([{ name: PARAMETER, value: told.before + 1 }], 'set');
  await until(() => seen.parameters[PARAMETER] === told.before + 1);
  const spawn = seen.services['/spawn'];
  const request = new MessageWriter(definition(spawn.request?.schema ?? spawn.requestSchema))
    .writeMessage({ x: 2, y: 3, theta: 0, name: `of_${protocol.split('.')[1]}` });
  client.sendServiceCallRequest({ serviceId: spawn.id, callId: 5, encoding: 'cdr', data: view(request) });
  await until(() => seen.answers.length);
  told.spawned = new MessageReader(definition(spawn.response?.schema ?? spawn.responseSchema)).readMessage(seen.answers[0].data).name;
  await until(() => seen.channels[`/${told.spawned}/pose`]);
  client.sendServiceCallRequest({ serviceId: 99999, callId: 6, encoding: 'cdr', data: new DataView(new ArrayBuffer(4)) });
  await until(() => seen.failures.length);
  told.failures = seen.failures;
  client.unsubscribe(subscription);
  client.close();
  console.log(JSON.stringify(told));
  process.exit(0);
}
main();
