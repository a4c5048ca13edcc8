import asyncio


async def main():
    await asyncio.create_subprocess_exec('ros2', 'node', 'list')


asyncio.run(main())
